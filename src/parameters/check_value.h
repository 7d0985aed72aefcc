// Compares one value with its declaration.
#pragma once

#include "parameters/tree.h"

namespace vibroimpact::parameters {

/// Fills value.numbers. Throws Refused with what is wrong and what is expected.
void check_value(Value &value, const VariableTable &variables);

/// One number of a value. Throws Refused.
Number checked_number(const std::string &text, const Dimension &dimension, const Range &range,
                      const std::string &example, const VariableTable &variables);

/// "'5 kg' is a mass [kg]; a length [m] is expected (greater than 0), for example 5 mm"
std::string wrong_dimension(const std::string &text, const Number &number,
                            const Dimension &expected, const Range &range,
                            const std::string &example);

/// "a length [m] is expected (greater than 0), for example 5 mm"; for lists, choices and all
/// others.
std::string expectation(const Key &key);

/// "1 to 3 values", "2 values", "any number of values"
std::string count_sentence(const Key &key);

bool boolean_value(const std::string &text);

} // namespace vibroimpact::parameters
