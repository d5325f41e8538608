#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace wedgesim {

/// What an InputError thrown by `action` says; empty if none was thrown.
template <typename Action>
std::string input_error_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace wedgesim
