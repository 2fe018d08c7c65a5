#include "common/plot/draw_figure.hpp"

#include <algorithm>
#include <vector>

namespace plot {
namespace {

/// Indices of the curves, lower layers first, in their order within a layer.
std::vector<std::size_t> by_layer(const std::deque<Curve>& curves) {
    std::vector<std::size_t> order(curves.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(), [&curves](std::size_t a, std::size_t b) {
        return curves[a].style.layer < curves[b].style.layer;
    });
    return order;
}

void draw_data(Canvas& canvas, const Panel& panel, const PanelLayout& layout) {
    const auto colours = curve_colours(panel);
    const auto order = by_layer(panel.curves);
    const auto draw_layers = [&](bool behind) {
        for (const std::size_t k : order)
            if ((panel.curves[k].style.layer < 0) == behind)
                draw_curve(canvas, panel.curves[k], colours[k], layout);
    };
    for (const auto& field : panel.fields) draw_field(canvas, field, layout);
    for (const auto& field : panel.fields) draw_contours(canvas, field, layout);
    draw_layers(true);
    const auto band_colour = band_colours(panel);
    for (std::size_t k = 0; k < panel.bands.size(); ++k)
        draw_band(canvas, panel.bands[k], band_colour[k], layout);
    for (const auto& discs : panel.discs) draw_discs(canvas, discs, layout);
    for (const auto& arrows : panel.arrows) draw_arrows(canvas, arrows, layout);
    for (const auto& slope : layout.slopes) draw_slope(canvas, slope);
    draw_layers(false);
}

void draw_panel(Canvas& canvas, const Panel& panel, const PanelLayout& layout) {
    canvas.clip(layout.frame);
    if (panel.grid) draw_grid(canvas, panel, layout);
    draw_data(canvas, panel, layout);
    canvas.unclip();
    draw_frame(canvas, layout);
    for (const auto& bar : layout.bars) draw_bar(canvas, bar);
    for (const auto& text : layout.texts) draw_text(canvas, text);
    for (const auto& note : layout.notes) draw_note(canvas, note);
    draw_legend(canvas, layout.legend);
}

}  // namespace

Image draw(Canvas& canvas, const Figure& figure) {
    const Layout layout =
        lay_out(figure, [&canvas](std::string_view text, double size) { return canvas.measure(text, size); });
    canvas.begin(layout.width, layout.height);
    for (const auto& text : layout.texts) draw_text(canvas, text);
    for (std::size_t k = 0; k < layout.panels.size(); ++k)
        if (!layout.panels[k].blank) draw_panel(canvas, figure.panels[k], layout.panels[k]);
    return canvas.finish();
}

void draw_text(Canvas& canvas, const TextBox& text) {
    canvas.text(text.anchor, text.text, text.style);
}

}  // namespace plot
