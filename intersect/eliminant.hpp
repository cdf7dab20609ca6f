// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Everything a user of the library calls, in one include: <eliminant/eliminant.hpp>.
#include <eliminant/base/context.hpp>
#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curve_surface/bezier_intersection.hpp>
#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curve_surface/implicitize.hpp>
#include <eliminant/intersect/curve_surface/surface_representation.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/intersect/curves/self_intersection.hpp>
#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/intersect/cylinders/enclosed_cylinders.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/version.hpp>
