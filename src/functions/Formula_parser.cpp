// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A Pratt parser: each operator binds its operands with a power, and an operand is read up to the next operator that
// binds less. See V. Pratt, Top down operator precedence, POPL 1973.

#include "Formula_parser.h"

#include "Formula_lexer.h"

#include <array>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace CGAL::Extremal_mesh_3::internal {
namespace {

// A level takes three stack frames, less than a kilobyte: far from any stack's end, and far above what people write.
constexpr int max_depth = 1000;
constexpr std::size_t max_length = 1'000'000;

enum Binding : int { binds_sum = 1, binds_product = 2, binds_sign = 3, binds_power = 4 };

constexpr std::size_t any_number = ~std::size_t{0};

struct Function {
  std::string_view name;
  Operation operation;
  std::size_t min_arguments, max_arguments;
};

constexpr std::array<Function, 23> functions{{
    {"abs", Operation::absolute, 1, 1},
    {"acos", Operation::acos, 1, 1},
    {"asin", Operation::asin, 1, 1},
    {"atan", Operation::atan, 1, 1},
    {"atan2", Operation::atan2, 2, 2},
    {"cbrt", Operation::cbrt, 1, 1},
    {"cos", Operation::cos, 1, 1},
    {"cosh", Operation::cosh, 1, 1},
    {"exp", Operation::exp, 1, 1},
    {"hypot", Operation::sqrt, 2, any_number}, // the root of the sum of squares
    {"ln", Operation::log, 1, 1},
    {"log", Operation::log, 1, 1},
    {"log10", Operation::log10, 1, 1},
    {"log2", Operation::log2, 1, 1},
    {"max", Operation::maximum, 2, any_number},
    {"min", Operation::minimum, 2, any_number},
    {"pow", Operation::power, 2, 2},
    {"sign", Operation::sign, 1, 1},
    {"sin", Operation::sin, 1, 1},
    {"sinh", Operation::sinh, 1, 1},
    {"sqrt", Operation::sqrt, 1, 1},
    {"tan", Operation::tan, 1, 1},
    {"tanh", Operation::tanh, 1, 1},
}};

const Function* find_function(std::string_view name) {
  for (const Function& f : functions)
    if (f.name == name)
      return &f;
  return nullptr;
}

bool is_variable_or_constant(std::string_view name) {
  return name == "x" || name == "y" || name == "z" || name == "pi" || name == "e";
}

class Parser {
public:
  Parser(std::string_view text, Expression& expression) : lexer_(text), expression_(expression) { advance(); }

  Expression::Id whole() {
    if (token_.kind == Token::end)
      formula_error(0, "the formula is empty");
    Expression::Id f = operand(binds_sum);
    if (is_symbol('=')) {
      advance();
      f = expression_.binary(Operation::subtract, f, operand(binds_sum));
      if (is_symbol('='))
        fail("a second \"=\"; a formula is f or f = g");
    }
    if (token_.kind != Token::end)
      expected("an operator or the end");
    return f;
  }

private:
  struct Level { // counts how deep the recursion is
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > max_depth)
        parser_.fail(fmt::format("more than {} levels of nesting", max_depth));
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    Parser& parser_;
  };

  void advance() { token_ = lexer_.next(); }
  bool is_symbol(char c) const { return token_.kind == Token::symbol && token_.text[0] == c; }
  [[noreturn]] void fail(const std::string& what) const { formula_error(token_.position, what); }

  /// reports what should have been where the current token is.
  [[noreturn]] void expected(const std::string& what) const {
    const bool starts_operand = token_.kind == Token::number || token_.kind == Token::name || is_symbol('(');
    if (starts_operand && what.starts_with("an operator"))
      fail(fmt::format("expected {} before {}; write * for a product", what, describe(token_)));
    if (is_symbol(',') && depth_ == 0)
      fail("unexpected \",\"; write a decimal point, not a comma");
    if (is_symbol(')') && depth_ == 0)
      fail("unexpected \")\" without a \"(\" before it");
    if (is_symbol('=') && depth_ > 0)
      fail("unexpected \"=\" inside of an expression");
    fail(fmt::format("expected {}, not {}", what, describe(token_)));
  }

  /// an operand and all operators after it that bind at least as much as `minimum`.
  Expression::Id operand(int minimum) {
    Expression::Id left = signed_primary();
    while (token_.kind == Token::symbol) {
      const char symbol = token_.text[0];
      if ((symbol == '+' || symbol == '-') && minimum <= binds_sum) {
        advance();
        left =
            expression_.binary(symbol == '+' ? Operation::add : Operation::subtract, left, operand_of(binds_sum + 1));
      } else if ((symbol == '*' || symbol == '/') && minimum <= binds_product) {
        advance();
        left = expression_.binary(symbol == '*' ? Operation::multiply : Operation::divide, left,
                                  operand_of(binds_product + 1));
      } else if (symbol == '^' && minimum <= binds_power) {
        advance();
        left = expression_.power(left, operand_of(binds_power)); // 2^3^2 is 2^(3^2)
      } else {
        break;
      }
    }
    return left;
  }

  /// an operand on the right of an operator.
  Expression::Id operand_of(int minimum) {
    const Level level(*this);
    return operand(minimum);
  }

  /// a number, name, call or parenthesis with the signs before it: -x^2 is -(x^2).
  Expression::Id signed_primary() {
    if (is_symbol('+') || is_symbol('-')) {
      const bool minus = is_symbol('-');
      advance();
      const Expression::Id u = operand_of(binds_sign);
      return minus ? expression_.unary(Operation::negate, u) : u;
    }
    if (token_.kind == Token::number) {
      const double value = token_.value;
      advance();
      return expression_.constant(value);
    }
    if (token_.kind == Token::name)
      return name();
    if (is_symbol('(')) {
      const std::size_t open = token_.position;
      const Level level(*this);
      advance();
      const Expression::Id u = operand(binds_sum);
      close(open);
      return u;
    }
    expected("a number, a variable, a function or \"(\"");
  }

  void close(std::size_t open) {
    if (!is_symbol(')'))
      expected(fmt::format("an operator or the \")\" that closes column {}", open + 1));
    advance();
  }

  Expression::Id name() {
    const Token token = token_;
    const Function* const function = find_function(token.text);
    if (function == nullptr && !is_variable_or_constant(token.text))
      unknown_name();
    advance();
    if (function != nullptr)
      return call(*function, token);
    if (token.text == "pi")
      return expression_.constant(std::numbers::pi);
    if (token.text == "e")
      return expression_.constant(std::numbers::e);
    return expression_.variable(static_cast<Expression::Id>(token.text[0] - 'x'));
  }

  [[noreturn]] void unknown_name() const {
    const std::string_view text = token_.text.substr(0, 40);
    std::string lower(text), product;
    for (char& c : lower)
      c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (is_variable_or_constant(lower) || find_function(lower) != nullptr)
      fail(fmt::format("unknown name \"{}\"; did you mean {}?", text, lower));
    if (lower.find_first_not_of("xyz") == std::string::npos) {
      for (const char c : lower)
        product += product.empty() ? std::string(1, c) : fmt::format("*{}", c);
      fail(fmt::format("unknown name \"{}\"; did you mean {}?", text, product));
    }
    std::string known = "x, y, z, pi, e";
    for (const Function& f : functions)
      known += fmt::format(", {}", f.name);
    fail(fmt::format("unknown name \"{}\"; known are {}", text, known));
  }

  Expression::Id call(const Function& function, const Token& token) {
    if (!is_symbol('('))
      expected(fmt::format("\"(\" after {}", function.name));
    const std::size_t open = token_.position;
    const Level level(*this);
    std::vector<Expression::Id> arguments;
    do {
      advance();
      arguments.push_back(operand(binds_sum));
    } while (is_symbol(','));
    close(open);
    if (arguments.size() < function.min_arguments || arguments.size() > function.max_arguments)
      formula_error(token.position,
                    fmt::format("{} takes {}{} argument{}, not {}", function.name, function.min_arguments,
                                function.max_arguments == any_number ? " or more" : "",
                                function.max_arguments == 1 ? "" : "s", arguments.size()));
    return apply_function(function, arguments);
  }

  Expression::Id apply_function(const Function& function, const std::vector<Expression::Id>& arguments) {
    Expression::Id u = arguments[0];
    if (function.name == "pow")
      return expression_.power(u, arguments[1]);
    if (function.name == "hypot") {
      const auto squared = [this](Expression::Id v) { return expression_.binary(Operation::multiply, v, v); };
      u = squared(u);
      for (std::size_t i = 1; i < arguments.size(); ++i)
        u = expression_.binary(Operation::add, u, squared(arguments[i]));
      return expression_.unary(Operation::sqrt, u);
    }
    if (is_unary(function.operation))
      return expression_.unary(function.operation, u);
    for (std::size_t i = 1; i < arguments.size(); ++i) // atan2, min, max
      u = expression_.binary(function.operation, u, arguments[i]);
    return u;
  }

  Formula_lexer lexer_;
  Expression& expression_;
  Token token_;
  int depth_ = 0;
};

} // namespace

Expression::Id parse_formula(std::string_view text, Expression& expression) {
  if (text.size() > max_length)
    formula_error(max_length, fmt::format("the formula is longer than {} characters", max_length));
  return Parser(text, expression).whole();
}

} // namespace CGAL::Extremal_mesh_3::internal
