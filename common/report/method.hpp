#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/app/command_line.hpp"
#include "common/app/error.hpp"
#include "common/app/option_text.hpp"
#include "common/app/parameters.hpp"
#include "common/plot/figure.hpp"
#include "common/report/chapter.hpp"

namespace report {

/// A way to compute something: a value with a name, a look, what may be turned at it, and how to build it.
/// Product is what is built, Setup what the building needs of the scene.
template <class Product, class Setup>
struct Method {
    std::string name;   ///< for options and results.csv
    std::string label;  ///< for figures and tables
    plot::Style look;   ///< the same in every figure; its label is filled in by styled()
    std::string kernel{};
    double h_over_dx = 1;          ///< smoothing length in spacings
    app::Parameters parameters{};  ///< of its effects
    std::function<std::unique_ptr<Product>(const Method&, const Setup&)> build{};

    std::unique_ptr<Product> make(const Setup& setup) const { return build(*this, setup); }
    plot::Style styled() const {
        plot::Style style = look;
        style.label = label;
        return style;
    }
};

/// Methods by name, in the order in which a chapter tells of them; one of them is recommended. M is a Method,
/// or has its members.
template <class M>
class Methods {
  public:
    /// Throws std::invalid_argument for a name that stands twice, or a recommended one that is not there.
    Methods(std::string recommended, std::vector<M> list)
        : recommended_{std::move(recommended)}, list_{std::move(list)} {
        for (const M& method : list_) {
            if (&find(method.name) != &method)
                throw std::invalid_argument{"two methods are named " + method.name};
        }
        find(recommended_);
    }
    auto begin() const { return list_.begin(); }
    auto end() const { return list_.end(); }
    std::size_t size() const { return list_.size(); }
    /// Throws std::invalid_argument for an unknown name.
    const M& operator[](const std::string& name) const { return find(name); }
    const M& recommended() const { return find(recommended_); }
    std::vector<M> named(const std::vector<std::string>& names) const {
        std::vector<M> chosen;
        for (const std::string& name : names) chosen.push_back(find(name));
        return chosen;
    }
    /// All but those.
    std::vector<M> without(const std::vector<std::string>& names) const {
        std::vector<M> rest;
        for (const M& method : list_) {
            if (std::find(names.begin(), names.end(), method.name) == names.end()) rest.push_back(method);
        }
        return rest;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const M& method : list_) names.push_back(method.name);
        return names;
    }
    /// One name a line: what `--method list` prints.
    std::string text() const {
        std::string text;
        for (const M& method : list_)
            text += method.name + (method.name == recommended_ ? " (recommended)\n" : "\n");
        return text;
    }

  private:
    const M& find(const std::string& name) const {
        for (const M& method : list_) {
            if (method.name == name) return method;
        }
        throw std::invalid_argument{"no such method: " + name};
    }
    std::string recommended_;
    std::vector<M> list_;
};

/// Tells the CSV files of a scene with which method, kernel, h and parameters they were made.
template <class M>
void tell(Run& run, const M& method) {
    run.parameter("method", method.name);
    run.parameter("kernel", method.kernel);
    run.parameter("h-over-dx", app::option_text::shown(method.h_over_dx));
    for (const app::Parameter& one : method.parameters.list())
        run.parameter(one.name, app::option_text::shown(one.value));
}

/// The options by which a reader chooses a method and turns what may be turned at it: --method, --kernel,
/// --h-over-dx, and one for each parameter of any of them.
template <class M>
class MethodOptions {
  public:
    /// `kernels`: those that every method can be run with; empty: each has its own only. `above`: what h over
    /// dx must be larger than with a kernel, whatever the range says.
    MethodOptions(const Methods<M>& methods, std::vector<std::string> kernels, app::Range h_over_dx,
                  std::function<double(const std::string& kernel)> above = {})
        : methods_{&methods}, kernels_{std::move(kernels)}, range_{h_over_dx}, above_{std::move(above)} {
        for (const M& method : methods) {
            for (const app::Parameter& one : method.parameters.list()) all_.add(one);
        }
        values_.assign(all_.list().size(), std::nan(""));
    }
    void declare(app::CommandLine& line) {
        line.text("method", method_, "NAME", "'list' names them; default: the recommended one");
        if (!kernels_.empty())
            line.choice("kernel", kernel_, kernels_, "smoothing kernel; default: the method's")
                .number("h-over-dx", h_over_dx_, range_, "spacings",
                        "smoothing length; default: the method's");
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const app::Parameter& one = all_.list()[k];
            line.number(one.name, values_[k], one.range, "",
                        one.meaning + " (" + takers(one.name) + "); default: the method's");
        }
    }
    bool wants_list() const { return method_ == "list"; }
    /// The method as it is to be run. Throws app::UsageError for a name that is not known, and for a
    /// parameter that the method does not have.
    M chosen() const {
        const auto names = methods_->names();
        if (!method_.empty() && std::find(names.begin(), names.end(), method_) == names.end())
            throw app::UsageError{"--method: " + method_ + " is not allowed; allowed: list, " +
                                  app::option_text::joined(names)};
        M method = method_.empty() ? methods_->recommended() : (*methods_)[method_];
        if (!kernel_.empty()) method.kernel = kernel_;
        if (!std::isnan(h_over_dx_)) method.h_over_dx = h_over_dx_;
        if (above_)
            app::require_above("h-over-dx", method.h_over_dx, above_(method.kernel),
                               "with the kernel " + method.kernel);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const std::string& name = all_.list()[k].name;
            if (std::isnan(values_[k])) continue;
            if (!method.parameters.has(name))
                throw app::UsageError{"--" + name + ": the method " + method.name +
                                      " does not take it; allowed with " + takers(name)};
            method.parameters.set(name, values_[k]);
        }
        return method;
    }

  private:
    std::string takers(const std::string& name) const {
        std::vector<std::string> names;
        for (const M& method : *methods_) {
            if (method.parameters.has(name)) names.push_back(method.name);
        }
        return app::option_text::joined(names);
    }

    const Methods<M>* methods_;
    std::vector<std::string> kernels_;
    app::Range range_;
    std::function<double(const std::string&)> above_;
    app::Parameters all_;
    std::string method_, kernel_;
    double h_over_dx_ = std::nan("");
    std::vector<double> values_;
};

}  // namespace report
