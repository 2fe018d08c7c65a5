#include "common/plot/extent.hpp"

#include <cmath>

namespace plot {
namespace {

using Visit = std::function<void(const DataPoint&)>;

void visit_curve(const Curve& curve, const Visit& visit) {
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        visit({.x = curve.x[i],
               .y = curve.y[i],
               .half_height = curve.error.empty() ? 0.0 : curve.error[i],
               .may_reach_zero = true});
}

void visit_band(const Band& band, const Visit& visit) {
    for (std::size_t i = 0; i < band.x.size(); ++i) {
        visit({.x = band.x[i], .y = band.low[i]});
        visit({.x = band.x[i], .y = band.high[i]});
    }
}

void visit_discs(const Discs& discs, const Visit& visit) {
    const double half = discs.data_diameter / 2;
    for (std::size_t i = 0; i < discs.x.size(); ++i)
        visit({.x = discs.x[i], .y = discs.y[i], .half_width = half, .half_height = half});
}

void visit_field(const Field& field, const Visit& visit) {
    if (field.x.empty() || field.y.empty()) return;
    for (const double x : {field.x.front(), field.x.back()})
        for (const double y : {field.y.front(), field.y.back()}) visit({.x = x, .y = y, .fills = true});
}

void visit_arrows(const Arrows& arrows, const Visit& visit) {
    for (std::size_t i = 0; i < arrows.x.size(); ++i) {
        visit({.x = arrows.x[i], .y = arrows.y[i]});
        visit({.x = arrows.x[i] + arrows.scale * arrows.u[i], .y = arrows.y[i] + arrows.scale * arrows.v[i]});
    }
}

}  // namespace

void for_each_point(const Panel& panel, const Visit& visit) {
    for (const auto& curve : panel.curves) visit_curve(curve, visit);
    for (const auto& band : panel.bands) visit_band(band, visit);
    for (const auto& discs : panel.discs) visit_discs(discs, visit);
    for (const auto& field : panel.fields) visit_field(field, visit);
    for (const auto& arrows : panel.arrows) visit_arrows(arrows, visit);
    for (const auto& slope : panel.slopes) {
        visit({.x = slope.x0, .y = slope.y0});
        visit({.x = slope.x1, .y = slope.y0 * std::pow(slope.x1 / slope.x0, slope.order)});
    }
    for (const auto& note : panel.notes) {
        if (!note.relative) visit({.x = note.x, .y = note.y});
        if (note.points_at) visit({.x = (*note.points_at)[0], .y = (*note.points_at)[1]});
    }
}

}  // namespace plot
