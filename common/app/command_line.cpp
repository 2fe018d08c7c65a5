#include "common/app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "common/app/error.hpp"
#include "common/app/files.hpp"
#include "common/app/help_formatter.hpp"
#include "common/app/option.hpp"
#include "common/app/option_text.hpp"

namespace app {
namespace {

void set_up(CLI::App& app) {
    app.set_help_flag("-h,--help", "print this help and exit");
    app.set_version_flag("--version", version(), "print the version and exit");
    app.allow_extras();  // reported by refuse_extras, with the nearest known name
}

[[noreturn]] void bad_default(std::string_view name) {
    throw std::invalid_argument{"the default of --" + std::string{name} + " is not an allowed value"};
}

}  // namespace

struct CommandLine::Implementation {
    std::unique_ptr<CLI::App> own_app;  // of the program; empty for a sub-command
    CLI::App* app = nullptr;
    std::vector<Option> options;
    std::vector<std::unique_ptr<CommandLine>> commands;
    bool foreign = false;  // what is declared next

    void add(Option option, const std::string& placeholder, const std::string& description) {
        if (foreign && find(std::string_view{option.name}.substr(2))) return;
        option.foreign = foreign;
        option.default_value = option.value();
        option.entry =
            option_text::entry(option.name + (placeholder.empty() ? "" : " " + placeholder), description);
        option.words = option.is_flag ? app->add_flag(option.name) : app->add_option(option.name);
        option.words->description(description)->option_text(placeholder);
        if (foreign) option.words->group("");  // not shown: --help tells who takes it
        option.words->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        options.push_back(std::move(option));
    }
    const Option* find(std::string_view name) const {
        const auto found = std::find_if(options.begin(), options.end(), [&](const Option& option) {
            return std::string_view{option.name}.substr(2) == name;
        });
        return found == options.end() ? nullptr : &*found;
    }
    const CommandLine* chosen() const {
        const auto found = std::find_if(commands.begin(), commands.end(),
                                        [](const auto& command) { return command->self_->app->parsed(); });
        return found == commands.end() ? nullptr : found->get();
    }
    std::vector<std::string> command_names() const {
        std::vector<std::string> names;
        for (const auto& command : commands) names.push_back(command->self_->app->get_name());
        return names;
    }
    [[noreturn]] void refuse_word(const std::string& word) const;
    void read_values() const;
    void read_value(const Option& option) const;
};

void CommandLine::Implementation::refuse_word(const std::string& given) const {
    const std::string word = given.substr(0, given.find('='));
    const bool is_option = word.size() > 1 && word[0] == '-';
    std::vector<std::string> known =
        is_option ? std::vector<std::string>{"help", "version"} : command_names();
    if (is_option)
        for (const auto& option : options) known.push_back(option.name.substr(2));
    throw UsageError{option_text::unknown(word, known, is_option, !commands.empty())};
}

void CommandLine::Implementation::read_values() const {
    for (const auto& option : options) read_value(option);
    if (const auto extras = app->remaining(false); !extras.empty()) refuse_word(extras.front());
    if (commands.empty()) return;
    const CommandLine* command = chosen();
    if (!command) throw UsageError{"a command is missing; known: " + option_text::joined(command_names())};
    command->self_->read_values();
}

void CommandLine::Implementation::read_value(const Option& option) const {
    if (option.words->count() == 0) return;
    if (option.words->count() > 1) throw UsageError{option.name + ": given more than once"};
    const std::string word = option.words->results().front();
    if (option.is_flag && word != "true") throw UsageError{option.name + ": takes no value"};
    // CLI11 takes any next word as the value, also an option's name: that is a forgotten value.
    if (word.starts_with("--")) throw UsageError{option.name + ": a value is missing before " + word};
    option.read(word);
}

CommandLine::CommandLine(std::string program, std::string description)
    : self_{std::make_unique<Implementation>()} {
    self_->own_app = std::make_unique<CLI::App>(std::move(description), std::move(program));
    self_->app = self_->own_app.get();
    self_->app->formatter(std::make_shared<HelpFormatter>());
    self_->app->require_subcommand(0, 1);
    set_up(*self_->app);
}
CommandLine::CommandLine(std::unique_ptr<Implementation> self) : self_{std::move(self)} {}
CommandLine::~CommandLine() = default;
CommandLine::CommandLine(CommandLine&&) noexcept = default;
CommandLine& CommandLine::operator=(CommandLine&&) noexcept = default;

CommandLine& CommandLine::number(std::string_view name, double& target, Range range, std::string_view unit,
                                 std::string_view meaning) {
    const bool has_default = !std::isnan(target);
    if (has_default && !range.contains(target)) bad_default(name);
    Option option{"--" + std::string{name}};
    option.read = [&target, range, full_name = option.name](const std::string& word) {
        target = option_text::parse_number(full_name, word, range);
    };
    option.value = [&target] { return option_text::shown(target); };
    self_->add(option, "X",
               option_text::described(meaning, unit, range.text(), has_default ? option.value() : ""));
    return *this;
}

CommandLine& CommandLine::integer(std::string_view name, long& target, long low, long high,
                                  std::string_view meaning) {
    if (target < low || target > high) bad_default(name);
    Option option{"--" + std::string{name}};
    option.read = [&target, low, high, full_name = option.name](const std::string& word) {
        target = option_text::parse_integer(full_name, word, low, high);
    };
    option.value = [&target] { return option_text::shown(target); };
    self_->add(option, "N",
               option_text::described(meaning, "", option_text::range_text(low, high), option.value()));
    return *this;
}

CommandLine& CommandLine::numbers(std::string_view name, std::vector<double>& target, Range range,
                                  std::string_view unit, std::string_view meaning, std::size_t count) {
    const auto allowed = [&](double value) { return range.contains(value); };
    if (!std::all_of(target.begin(), target.end(), allowed)) bad_default(name);
    if (count > 0 && !target.empty() && target.size() != count) bad_default(name);
    Option option{"--" + std::string{name}};
    option.read = [&target, range, count, full_name = option.name](const std::string& word) {
        target = option_text::parse_numbers(full_name, word, range, count);
    };
    option.value = [&target] { return option_text::shown(target); };
    const std::string placeholder = count == 0   ? "LIST"
                                    : count == 1 ? "X"
                                                 : "X1,..,X" + std::to_string(count);
    self_->add(option, placeholder, option_text::described(meaning, unit, range.text(), option.value()));
    return *this;
}

CommandLine& CommandLine::choice(std::string_view name, std::string& target, std::vector<std::string> allowed,
                                 std::string_view meaning) {
    if (!target.empty() && std::find(allowed.begin(), allowed.end(), target) == allowed.end())
        bad_default(name);
    Option option{"--" + std::string{name}};
    const std::string description =
        option_text::described(meaning, "", "one of " + option_text::joined(allowed), target);
    option.read = [&target, allowed = std::move(allowed), full_name = option.name](const std::string& word) {
        target = option_text::parse_choice(full_name, word, allowed);
    };
    option.value = [&target] { return target; };
    self_->add(option, "NAME", description);
    return *this;
}

CommandLine& CommandLine::text(std::string_view name, std::string& target, std::string_view placeholder,
                               std::string_view meaning) {
    Option option{"--" + std::string{name}};
    option.read = [&target, full_name = option.name](const std::string& word) {
        if (word.empty()) throw UsageError{full_name + ": a value is missing"};
        target = word;
    };
    option.value = [&target] { return target; };
    self_->add(option, std::string{placeholder}, option_text::described(meaning, "", "", target));
    return *this;
}

CommandLine& CommandLine::flag(std::string_view name, bool& target, std::string_view meaning) {
    Option option{"--" + std::string{name}};
    option.is_flag = true;
    option.read = [&target](const std::string&) { target = true; };
    option.value = [&target] { return std::string{target ? "true" : ""}; };
    self_->add(option, "", std::string{meaning});
    return *this;
}

CommandLine& CommandLine::foreign() {
    self_->foreign = true;
    return *this;
}

std::vector<std::string> CommandLine::refused() const {
    std::vector<std::string> given;
    for (const auto& option : self_->options) {
        if (option.foreign && option.words->count() > 0) given.push_back(option.name);
    }
    return given;
}

std::string CommandLine::entries() const {
    std::string text;
    for (const auto& option : self_->options) text += option.foreign ? "" : option.entry;
    return text;
}

std::vector<std::string> CommandLine::names() const {
    std::vector<std::string> names;
    for (const auto& option : self_->options) names.push_back(option.name.substr(2));
    return names;
}

CommandLine& CommandLine::footer(std::string text) {
    self_->app->footer(std::move(text));
    return *this;
}

CommandLine& CommandLine::command(std::string_view name, std::string_view description) {
    auto inner = std::make_unique<Implementation>();
    inner->app = self_->app->add_subcommand(std::string{name}, std::string{description});
    inner->app->group("Commands");
    set_up(*inner->app);
    self_->commands.push_back(std::unique_ptr<CommandLine>{new CommandLine{std::move(inner)}});
    return *self_->commands.back();
}

std::string CommandLine::chosen_command() const {
    const CommandLine* command = self_->chosen();
    return command ? command->self_->app->get_name() : "";
}

bool CommandLine::given(std::string_view name) const {
    if (const Option* option = self_->find(name)) return option->words->count() > 0;
    const CommandLine* command = self_->chosen();
    return command && command->given(name);
}

std::vector<std::pair<std::string, std::string>> CommandLine::values(
    const std::vector<std::string>& except) const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& option : self_->options) {
        const std::string value = option.value();
        if (option.foreign || option.is_one_of(except) || value.empty() || value == "nan") continue;
        all.emplace_back(option.name.substr(2), value);
    }
    return all;
}

std::string CommandLine::changed(const std::vector<std::string>& except) const {
    std::string text;
    for (const auto& option : self_->options) {
        const std::string value = option.value();
        if (option.is_one_of(except) || option.words->count() == 0 || value == option.default_value) continue;
        text += (text.empty() ? "" : " ") + option.name;
        if (!option.is_flag) text += " " + option_text::quoted(value);
    }
    return text;
}

bool CommandLine::parse(int argc, const char* const* argv) {
    std::vector<std::string> words;  // last first, as CLI11 wants them
    for (int k = argc - 1; k > 0; --k) {
        const std::string word = argv[k];
        // CLI11 would take the next word for the value.
        if (word.size() > 3 && word.starts_with("--") && word.find('=') + 1 == word.size())
            throw UsageError{word.substr(0, word.size() - 1) + ": a value is missing"};
        if (option_text::has_one_dash(word)) self_->refuse_word(word);
        words.push_back(word);
    }
    try {
        self_->app->parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        write_stdout(self_->app->help());
        return false;
    } catch (const CLI::CallForVersion& call) {
        write_stdout(std::string{call.what()} + "\n");
        return false;
    } catch (const CLI::ArgumentMismatch& error) {  // "--name: 1 required missing"
        const std::string message = error.what();
        throw UsageError{message.substr(0, message.find(':')) + ": a value is missing"};
    } catch (const CLI::Error& error) {
        throw UsageError{error.what()};
    }
    self_->read_values();
    return true;
}

std::string version() {
    return SPH_VERSION;
}

}  // namespace app
