// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Everything a user of the library calls, in one include: <eliminant/eliminant.hpp>.
#include <eliminant/base/context.hpp>
#include <eliminant/base/error.hpp>
#include <eliminant/intersect/bezier_intersection.hpp>
#include <eliminant/intersect/curve_curve.hpp>
#include <eliminant/intersect/curve_surface.hpp>
#include <eliminant/intersect/curve_topology.hpp>
#include <eliminant/intersect/cylinder_extraction.hpp>
#include <eliminant/intersect/cylinders.hpp>
#include <eliminant/intersect/enclosed_cylinders.hpp>
#include <eliminant/intersect/implicitize.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/plane_curves.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/intersect/self_intersection.hpp>
#include <eliminant/intersect/surface_representation.hpp>
#include <eliminant/intersect/surface_surface.hpp>
#include <eliminant/version.hpp>
