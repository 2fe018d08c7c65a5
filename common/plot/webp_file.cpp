#include "common/plot/webp_file.hpp"

#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "common/plot/canvas_boxes.hpp"

// libwebp has an encoder of animations (WebPAnimEncoder), which is not used: it leaves out what differs by
// less than 6/255 from the frame before, so that a field that changes slowly stands still: one was wrong by
// 8/255 on average, in steps that are seen. Key frames alone mend that, and make its file twice as large.
namespace plot {
namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw std::runtime_error{"WebP: " + what};
}
void require_mux(WebPMuxError status) {
    if (status != WEBP_MUX_OK) refuse(fmt::format("libwebpmux reports error {}", static_cast<int>(status)));
}

/// Lines and markers in colour are thinner than the 2x2 pixels that share a colour in lossy WebP: with the
/// sharp conversion they keep theirs, for an eighth of the file and a second in 60 frames.
WebPConfig configuration() {
    WebPConfig config;
    constexpr float quality = 70;
    if (WebPConfigPreset(&config, WEBP_PRESET_DEFAULT, quality) == 0) refuse("another version of libwebp");
    config.use_sharp_yuv = 1;
    config.thread_level = 0;  // bytes must not depend on the machine
    return config;
}

/// Part of an image in libwebp's hands, and the bytes that become of it.
struct Picture {
    Picture() {
        WebPMemoryWriterInit(&bytes);
        if (WebPPictureInit(&picture) == 0) refuse("another version of libwebp");
        picture.use_argb = 1;
        picture.writer = WebPMemoryWrite;
        picture.custom_ptr = &bytes;
    }
    ~Picture() {
        WebPPictureFree(&picture);
        WebPMemoryWriterClear(&bytes);
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    /// The bytes live as long as this object.
    WebPData encode(const Image& image, const PixelBox& box, const WebPConfig& config) {
        picture.width = box.width();
        picture.height = box.height();
        const std::ptrdiff_t stride = 3 * static_cast<std::ptrdiff_t>(image.width);
        const std::uint8_t* first = image.rgb.data() + box.top * stride + 3 * box.left;
        if (WebPPictureImportRGB(&picture, first, static_cast<int>(stride)) == 0 ||
            WebPEncode(&config, &picture) == 0)
            refuse(fmt::format("libwebp reports error {} for {} x {} pixels",
                               static_cast<int>(picture.error_code), picture.width, picture.height));
        return {bytes.mem, bytes.size};
    }

    WebPPicture picture;
    WebPMemoryWriter bytes;
};

/// The smallest box with all that differs, its left top corner at even numbers, as WebP wants. Of equal
/// images one corner: a frame must have some pixels.
PixelBox difference(const Image& image, const Image& before) {
    PixelBox box{image.width, image.height, 0, 0};
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* row = image.rgb.data() + static_cast<std::size_t>(y) * stride;
        const std::uint8_t* row_before = before.rgb.data() + static_cast<std::size_t>(y) * stride;
        if (std::memcmp(row, row_before, stride) == 0) continue;
        const auto first = std::mismatch(row, row + stride, row_before).first - row;
        auto last = static_cast<std::ptrdiff_t>(stride) - 1;
        while (row[last] == row_before[last]) --last;
        box.left = std::min(box.left, static_cast<int>(first / 3));
        box.right = std::max(box.right, static_cast<int>(last / 3) + 1);
        box.top = std::min(box.top, y);
        box.bottom = y + 1;
    }
    if (box.bottom == 0) return {0, 0, std::min(2, image.width), std::min(2, image.height)};
    box.left -= box.left % 2;
    box.top -= box.top % 2;
    return box;
}

}  // namespace

struct WebpWriter::Implementation {
    std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)> mux{WebPMuxNew(), WebPMuxDelete};
    WebPConfig config = configuration();
    std::string name;
    int count = 0;  // of the frames so far
    Image last{};
};

WebpWriter::WebpWriter(const std::string& name) : self_{std::make_unique<Implementation>()} {
    if (!self_->mux) refuse("no memory");
    self_->name = name;
}
WebpWriter::~WebpWriter() = default;

void WebpWriter::add(const Image& image, int milliseconds) {
    Image& last = self_->last;
    const bool first = self_->count++ == 0;
    if (!first && (image.width != last.width || image.height != last.height))
        throw std::invalid_argument{
            fmt::format("animation {}: frame {} has {} x {} pixels, those before {} x {}", self_->name,
                        self_->count, image.width, image.height, last.width, last.height)};
    const PixelBox box = first ? PixelBox{0, 0, image.width, image.height} : difference(image, last);
    Picture picture;
    const WebPMuxFrameInfo frame{.bitstream = picture.encode(image, box, self_->config),
                                 .x_offset = box.left,
                                 .y_offset = box.top,
                                 .duration = milliseconds,
                                 .id = WEBP_CHUNK_ANMF,
                                 .dispose_method = WEBP_MUX_DISPOSE_NONE,
                                 .blend_method = WEBP_MUX_NO_BLEND,
                                 .pad = {}};
    constexpr int copy = 1;
    require_mux(WebPMuxPushFrame(self_->mux.get(), &frame, copy));
    last = image;
}

std::string WebpWriter::finish(const std::string& xmp) {
    WebPMux* mux = self_->mux.get();
    const WebPMuxAnimParams white_for_ever{.bgcolor = 0xffffffff, .loop_count = 0};
    require_mux(WebPMuxSetAnimationParams(mux, &white_for_ever));
    require_mux(WebPMuxSetCanvasSize(mux, self_->last.width, self_->last.height));
    const WebPData packet{reinterpret_cast<const std::uint8_t*>(xmp.data()), xmp.size()};
    constexpr int copy = 1;
    require_mux(WebPMuxSetChunk(mux, "XMP ", &packet, copy));
    WebPData file;
    WebPDataInit(&file);
    const std::unique_ptr<WebPData, decltype(&WebPDataClear)> owner{&file, WebPDataClear};
    require_mux(WebPMuxAssemble(mux, &file));
    return {reinterpret_cast<const char*>(file.bytes), file.size};
}

std::string webp_version() {
    const int version = WebPGetEncoderVersion();  // one byte each
    return fmt::format("libwebp {}.{}.{}", version >> 16, (version >> 8) & 0xff, version & 0xff);
}

}  // namespace plot
