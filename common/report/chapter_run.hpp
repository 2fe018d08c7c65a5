#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "common/app/progress.hpp"
#include "common/plot/save.hpp"
#include "common/report/chapter.hpp"
#include "common/report/claims.hpp"

/// How a chapter's figures are run, and what they leave. Used by chapter.cpp.
namespace report {

/// What the command line asks of the figures.
struct Settings {
    bool quick = false;
    bool check_text = false;  ///< nothing is drawn, written or printed, and work is timed only once
    int threads = 1;
    unsigned long seed = 1;
    std::filesystem::path out;
    plot::Metadata metadata;  ///< its csv_head heads all CSV files
};

/// What the figures say of the text.
struct Told {
    Blocks blocks;
    Claims claims;
};

/// One figure's or scene's run: its rows are kept apart until it is complete.
class FigureRun : public Run {
  public:
    /// `studio` is opened at the first figure that is drawn; `told` is that of all figures; only a
    /// `timed` run may hand over times.
    FigureRun(std::string scene, bool timed, const Settings& settings, std::optional<plot::Studio>& studio,
              Told& told, app::Progress& progress);

    bool quick() const override { return settings_.quick; }
    bool checking() const override { return settings_.check_text; }
    int threads() const override { return settings_.threads; }
    unsigned long seed() const override { return settings_.seed; }
    void result(const std::string& method, long n, const std::string& quantity, double value,
                const std::string& unit) override;
    void save(const plot::Figure& figure) override;
    void save(const plot::Animation& animation) override;
    void fill(const std::string& name, const std::string& text) override;
    void claim(const std::string& name, const std::function<bool()>& holds, Needs needs) override;
    Timing time(const std::function<void()>& work) override;
    void write(const std::string& file_name, const std::string& text) override;
    void parameter(const std::string& name, const std::string& value) override;
    void print(const std::string& text) override;
    void warn(const std::string& text) override;
    std::function<void(double)> progress() override;

    const Results& results() const { return results_; }

  private:
    /// Nothing where only the text is being checked.
    template <class Drawing>
    void save_drawing(const Drawing& drawing);
    void require_timed(bool is_time, const std::string& what) const;

    std::string scene_;
    bool timed_;
    const Settings& settings_;
    plot::Metadata metadata_;  // the settings', and what parameter() adds
    std::optional<plot::Studio>& studio_;
    Told& told_;
    app::Progress& progress_;
    Results results_;
};

}  // namespace report
