#pragma once
#include <map>
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

/// A run that remembers what it is handed.
class FakeRun : public report::Run {
  public:
    bool is_quick = false, is_checking = false;
    double best = 0;                  ///< what time() says
    std::vector<std::string> rows{};  ///< "method,n,quantity,value,unit"
    std::map<std::string, std::string> filled{};

    bool quick() const override { return is_quick; }
    bool checking() const override { return is_checking; }
    int threads() const override { return 1; }
    unsigned long seed() const override { return 1; }
    void result(const std::string& method, long n, const std::string& quantity, double value,
                const std::string& unit) override {
        rows.push_back(method + "," + std::to_string(n) + "," + quantity + "," + report::number(value, 3) +
                       "," + unit);
    }
    void save(const plot::Figure&) override {}
    void save(const plot::Animation&) override {}
    void fill(const std::string& name, const std::string& text) override { filled[name] = text; }
    std::map<std::string, bool> claims{};
    void claim(const std::string& name, const std::function<bool()>& holds, report::Needs needs) override {
        if (!is_quick || needs == report::Needs::any_run) claims[name] = holds();
    }
    report::Timing time(const std::function<void()>& work) override {
        work();
        return {best, best, 1};
    }
    void write(const std::string&, const std::string&) override {}
    void parameter(const std::string&, const std::string&) override {}
    void print(const std::string&) override {}
    void warn(const std::string&) override {}
    std::function<void(double)> progress() override {
        return [](double) {};
    }
};
