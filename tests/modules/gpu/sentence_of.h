#pragma once

#include "basics/error.h"

#include <string>

// The sentence of the MachineError that the call throws; empty where it throws nothing.
template <class Call>
std::string machine_sentence_of(const Call& call) {
    try {
        call();
    } catch (const raysteps::MachineError& error) {
        return error.what();
    }
    return "";
}
