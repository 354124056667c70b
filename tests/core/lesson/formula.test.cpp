#include "lesson/formula.hpp"

#include <doctest/doctest.h>

#include <array>

using snug::lesson::plain_formula;

TEST_CASE("a formula is written in one line of Unicode") {
  struct Case {
    const char *tex, *plain;
  };
  const auto cases = std::to_array<Case>({
      {R"(\lvert T \cdot L \rvert > r_A + r_B)", "|T · L| > r_A + r_B"},
      {R"(n \cdot p + d)", "n · p + d"},
      {R"(r' = \frac{r + d}{2})", "r′ = (r + d)/2"},
      {R"(c' = c + \frac{r' - r}{d} (p - c))", "c′ = c + (r′ − r)/d (p − c)"},
      {R"(\frac{1}{n}\sum_i (p_i - \mu)^2)", "1/n ∑_i (p_i − μ)²"},
      {R"(\mu = \frac{1}{n} \sum_{k} p_k)", "μ = 1/n ∑_k p_k"},
      {R"(r = \sum_{i} e_i \, |u_i \cdot L|)", "r = ∑_i e_i |u_i · L|"},
      {R"(\min_k u \cdot p_k)", "min_k u · p_k"},
      {R"(\max_i = \max_{p} \, n_i \cdot p)", "max_i = max_p n_i · p"},
      {R"(a_{\max} < b_{\min} \quad \text{or} \quad b_{\max} < a_{\min})", "a_max < b_min or b_max < a_min"},
      {R"(\log t = \log c + a \log n)", "log t = log c + a log n"},
      {R"(n (n - 1) / 2)", "n(n − 1)/2"},
      {R"(L = u_i^A \times u_j^B)", "L = u_i^A × u_j^B"},
      {R"(x_1^2 + x_{10} \le -1)", "x₁² + x₁₀ ≤ −1"},
      {R"(\sqrt{a^2 + b^2})", "√(a² + b²)"},
      {R"(\sqrt 2)", "√2"},
      {R"(\lVert p - c \rVert)", "‖p − c‖"},
      {R"(a_{i+1})", "a_(i + 1)"},
      {R"(\max(a, b))", "max(a,b)"},
      {R"(\text{depth} = \min d)", "depth = min d"},
      {R"(T = n_{b} C_{b} + n_{f} F)", "T = n_b C_b + n_f F"},
      {R"(n_{p} (C_{v} + (1 - h) f C_{x}))", "n_p(C_v + (1 − h)f C_x)"},
      {R"(u_x v_y - u_y v_x)", "u_x v_y − u_y v_x"},
      {R"(u_i^A v)", "u_i^A v"},
      {R"(\mu_i \mu_j)", "μ_i μ_j"},
      {R"(2 x_i)", "2 x_i"},
      {R"(\mu n_b)", "μ n_b"},
      {R"(\lVert n_b \rVert)", "‖n_b‖"},
      {R"(|t_1R_{11} + t_2R_{21}|)", "|t₁R₁₁ + t₂R₂₁|"},
      {R"(\mathrm{min}_i + n_i \cdot t)", "min_i + n_i · t"},
      {"", ""},
  });
  for (const Case& one : cases) {
    CAPTURE(one.tex);
    const auto plain = plain_formula(one.tex);
    REQUIRE(plain.has_value());
    CHECK(*plain == one.plain);
  }
}

TEST_CASE("a formula that cannot be written is an error that says why") {
  struct Case {
    const char *tex, *why;
  };
  for (const Case& one : std::to_array<Case>({{R"(\foo x)", R"(\foo is not known here)"},
                                              {R"({a)", "a { has no }"},
                                              {R"(a})", "a } has no {"},
                                              {R"(x_)", "something is missing at the end"},
                                              {R"(\frac{a})", "something is missing at the end"},
                                              {"\\", "\\ is not known here"}})) {
    CAPTURE(one.tex);
    const auto plain = plain_formula(one.tex);
    REQUIRE_FALSE(plain.has_value());
    CHECK(plain.error() == one.why);
  }
  CHECK_FALSE(plain_formula(std::string(100, '{')).has_value());
}
