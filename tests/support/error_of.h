#pragma once

#include "basics/error.h"

#include <string>

// The sentence of the InputError that the call throws; empty where it throws nothing.
template <class Call>
std::string error_of(const Call& call) {
    try {
        call();
    } catch (const raysteps::InputError& error) {
        return error.what();
    }
    return "";
}
