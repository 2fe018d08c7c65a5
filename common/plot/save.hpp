#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "common/app/error.hpp"
#include "common/plot/animation.hpp"
#include "common/plot/figure.hpp"

namespace plot {

/// Text stored in the PNG (iTXt chunks) or WebP (XMP). No dates, no folders, no thread counts: an unchanged
/// figure is an unchanged file.
struct Metadata {
    std::string command;     ///< "./tutorial run 01 --only kernels"
    std::string parameters;  ///< "h_over_dx=1.2 jitter=0.3 seed=1"
    std::string revision;    ///< of the source that computed the figure
    std::string csv_head{};  ///< lines "# name=value" that the CSV begins with; none in a figure of the book
};

inline constexpr std::size_t largest_animation = 1'500'000;  // bytes of the WebP: a text shows several

/// An animation whose file would be larger: the message names its size and the limit.
struct TooLarge : app::Error {
    explicit TooLarge(const std::string& message) : Error{app::ExitCode::failed, message} {}
};

/// Draws many figures with one OpenGL context (a context and its shaders cost more than a figure).
class Studio {
  public:
    /// Throws app::IoError (missing font, no renderer), naming what is missing and its Debian package.
    Studio();
    ~Studio();
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    /// Writes folder/name.png and folder/name.csv, each atomically. Throws std::invalid_argument with the
    /// first of faults(figure), app::IoError if a file cannot be written.
    void save(const Figure& figure, const std::filesystem::path& folder, const Metadata& metadata);

    /// Writes folder/name.webp and folder/name.csv, each atomically; nothing before all is drawn. Frames are
    /// drawn as figures are, and halved where they are wider than 1000 pixels; they are lossy (quality 70).
    /// Throws std::invalid_argument with the first of faults(animation) or if a frame has another size than
    /// the first, TooLarge, and app::IoError if a file cannot be written or libwebp was missing when this
    /// program was built, with its Debian package.
    void save(const Animation& animation, const std::filesystem::path& folder, const Metadata& metadata);

    /// "OSMesa, Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string renderer() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

/// The data of every curve, band, disc, field and arrow as CSV, one row a point, with the seven digits that a
/// drawing can show. Columns: panel,kind,label,x,y,value,error (panel is its letter;
/// unused cells are empty). Bands have rows of the kinds "band low" and "band high", their bounds in y;
/// arrows of the kinds "arrow u" and "arrow v", the components in value.
std::string data_csv(const Figure& figure);
/// The same of every frame, behind a column `frame` that counts from 1.
std::string data_csv(const Animation& animation);

}  // namespace plot
