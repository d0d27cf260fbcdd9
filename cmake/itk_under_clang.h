// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Included by force, before all else, where clang compiles what includes ITK: Debian's ITK knows only the compiler that it was
// built with, and an #error stands in the way of any other. Its answers for g++ 12 hold for clang 14, too.
#ifndef EXTREMAL_MESH_3_CMAKE_ITK_UNDER_CLANG_H
#define EXTREMAL_MESH_3_CMAKE_ITK_UNDER_CLANG_H

#pragma push_macro("__clang__")
#pragma push_macro("__GNUC__")
#undef __clang__
#undef __GNUC__
#define __GNUC__ 12
#include <itk_compiler_detection.h>
#pragma pop_macro("__GNUC__")
#pragma pop_macro("__clang__")

#endif // EXTREMAL_MESH_3_CMAKE_ITK_UNDER_CLANG_H
