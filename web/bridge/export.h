/// \file
/// How functions are shown to JavaScript. docs/decisions/0058-web-package.md has the conventions.
#pragma once

/// A function of the module, by this name.
#define SOMS_EXPORT(function) extern "C" __attribute__((export_name(#function)))
