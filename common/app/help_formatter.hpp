#pragma once
#include <CLI/CLI.hpp>

#include "common/app/option_text.hpp"

namespace app {

/// --help in this project's form: CLI11's own does not wrap lines.
class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_option(const CLI::Option* option, bool) const override {
        return option_text::entry(option->get_name(false, true) + make_option_opts(option),
                                  option->get_description());
    }
    std::string make_option_opts(const CLI::Option* option) const override {
        return option->get_option_text().empty() ? "" : " " + option->get_option_text();
    }
    std::string make_subcommand(const CLI::App* command) const override {
        return option_text::entry(command->get_name(), command->get_description());
    }
    std::string make_usage(const CLI::App* app, std::string name) const override {
        return "\nUsage: " + name + (app->get_subcommands({}).empty() ? "" : " COMMAND") + " [options]\n";
    }
    std::string make_footer(const CLI::App* app) const override {
        return app->get_footer().empty() ? "" : app->get_footer() + "\n";
    }
};

}  // namespace app
