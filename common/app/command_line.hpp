#pragma once
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace app {

/// Allowed values of an option. Both ends are included unless marked open.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;
    bool contains(double value) const noexcept;  ///< false for NaN and for infinities
    std::string text() const;                    ///< "> 0", "0..1", "1e-3..10", "any finite number"
};
constexpr Range any{};
constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, false};
constexpr Range non_negative{0, std::numeric_limits<double>::infinity(), false, false};

/// The options of one program (or of one sub-command of it): each is declared with its meaning, unit, range
/// and default (the target's value when it is declared), and `--help` prints them.
/// A thin front of CLI11, compiled once, so that programs do not pay for its headers.
class CommandLine {
  public:
    CommandLine(std::string program, std::string description);
    ~CommandLine();
    CommandLine(CommandLine&&) noexcept;
    CommandLine& operator=(CommandLine&&) noexcept;

    /// `name` without the leading dashes ("h-over-dx"); `unit` "" for a pure number. A target that is NaN has
    /// no default. All declarations throw std::invalid_argument for a default that is not allowed.
    CommandLine& number(std::string_view name, double& target, Range range, std::string_view unit,
                        std::string_view meaning);
    CommandLine& integer(std::string_view name, long& target, long low, long high, std::string_view meaning);
    /// A comma-separated list; it may begin with a minus sign (`--left -1,2,3` and `--left=-1,2,3`).
    /// `count` > 0 demands exactly that many values.
    CommandLine& numbers(std::string_view name, std::vector<double>& target, Range range,
                         std::string_view unit, std::string_view meaning, std::size_t count = 0);
    /// One of `allowed`; a wrong value is answered with the nearest allowed one. "" as default: none.
    CommandLine& choice(std::string_view name, std::string& target, std::vector<std::string> allowed,
                        std::string_view meaning);
    CommandLine& text(std::string_view name, std::string& target, std::string_view placeholder,
                      std::string_view meaning);
    CommandLine& flag(std::string_view name, bool& target, std::string_view meaning);
    /// Options declared from here on are not taken by this run, but by others that --help tells of: their
    /// values are read and checked, and refused() names those that were given. A name that is declared
    /// already is not declared again.
    CommandLine& foreign();
    /// "--gamma --time": the foreign options that were given on the parsed line.
    std::vector<std::string> refused() const;
    /// The declared options with meaning, unit, range and default, as --help prints them.
    std::string entries() const;
    /// Their names, without the dashes.
    std::vector<std::string> names() const;
    /// Text printed at the end of --help (examples, list of scenes).
    CommandLine& footer(std::string text);
    /// A sub-command (`exact burgers`); `declare`d options belong to it. The reference stays valid.
    CommandLine& command(std::string_view name, std::string_view description);

    /// The sub-command that was given on the parsed line, "" if none.
    std::string chosen_command() const;
    /// True if the user gave this option (of the program or of the chosen sub-command) on the parsed line.
    bool given(std::string_view name) const;
    /// Name and value of every option that this run takes and that has one, given or by default, without
    /// those named in `except`.
    std::vector<std::pair<std::string, std::string>> values(const std::vector<std::string>& except) const;
    /// The options that the user gave and whose value differs from the default, as they would be typed, in
    /// the order of their declaration ("--particles 50 --jitter 0.1"): the scene as metadata. Without the
    /// options named in `except`, and without those of sub-commands.
    std::string changed(const std::vector<std::string>& except = {}) const;

    /// Parses; fills the targets. A program with sub-commands demands exactly one of them. Returns false if
    /// the line asked for --help or --version, which have been printed then. Throws UsageError: one line that
    /// names the option, the value and the allowed range, or the nearest known option for an unknown one.
    [[nodiscard]] bool parse(int argc, const char* const* argv);

  private:
    struct Implementation;
    explicit CommandLine(std::unique_ptr<Implementation>);
    std::unique_ptr<Implementation> self_;
};

/// For a bound that another option sets: throws UsageError, "--name: 0.6 is not allowed with the kernel
/// cubic; allowed: above 0.6667", unless value > bound. `where`: "with the kernel cubic".
void require_above(const std::string& name, double value, double bound, const std::string& where);

/// The element of `known` with the smallest edit distance to `word`; "" if none is near (more than half of
/// the letters differ).
std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// Version of the project, as printed by --version.
std::string version();

}  // namespace app
