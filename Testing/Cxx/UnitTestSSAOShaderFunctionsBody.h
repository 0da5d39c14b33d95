// SPDX-License-Identifier: BSD-3-Clause

// Included by UnitTestSSAOShaderFunctions.cxx once for each precision, within a namespace; no
// include guard.

namespace inPrecision
{
constexpr Scalar Epsilon = std::numeric_limits<Scalar>::epsilon();

//------------------------------------------------------------------------------
// Directions all over the sphere, with the axes, the octahedron's edges and tiny components.
inline std::vector<vec3> Directions()
{
  std::vector<vec3> directions;
  for (int x = -1; x <= 1; ++x)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int z = -1; z <= 1; ++z)
      {
        if (x || y || z)
        {
          directions.push_back(normalize(vec3(x, y, z)));
          directions.push_back(normalize(vec3(x, y, z) + vec3(Scalar(1.0e-5), 0, Scalar(-2.0e-5))));
        }
      }
    }
  }
  for (int i = 0; i < 5000; ++i)
  {
    const double z = 1.0 - 2.0 * (i + 0.5) / 5000.0;
    const double angle = 2.399963229728653 * i;
    const double radius = std::sqrt(1.0 - z * z);
    directions.push_back(normalize(
      vec3(Scalar(radius * std::cos(angle)), Scalar(radius * std::sin(angle)), Scalar(z))));
  }
  return directions;
}

//------------------------------------------------------------------------------
inline void TestNormals(vtkSSAOTestMonitor& test, const std::string& what)
{
  double encoded = 0.0;
  double roundTrip = 0.0;
  double packed = 0.0;
  double unit = 0.0;
  double largest = 0.0;
  bool whole = true;
  for (const vec3& normal : Directions())
  {
    const vec2 code = ssaoOctahedralEncode(normal);
    encoded = std::max<double>(encoded, std::max(std::abs(code.x), std::abs(code.y)));
    roundTrip = std::max<double>(roundTrip, length(ssaoOctahedralDecode(code) - normal));
    const Scalar number = ssaoPackNormal(normal);
    const vec3 unpacked = ssaoUnpackNormal(number);
    packed = std::max<double>(packed, length(unpacked - normal));
    unit = std::max<double>(unit, std::abs(length(unpacked) - Scalar(1.0)));
    largest = std::max<double>(largest, number);
    whole = whole && number >= Scalar(0.0) && std::floor(number) == number;
  }
  test.ExpectAtMost(encoded, 1.0 + Epsilon, what + "largest octahedral coordinate");
  test.ExpectAtMost(roundTrip, 8.0 * Epsilon, what + "octahedral round trip");
  // Steps of 2/4094 in both coordinates: at most half a diagonal of that, which is sqrt(3) times as
  // long on the face of the octahedron, whose middle is only 1/sqrt(3) from the centre.
  test.ExpectAtMost(
    packed, 0.5 * std::sqrt(2.0) * 2.0 / 4094.0 * 3.0, what + "error of a packed normal");
  test.ExpectAtMost(unit, 4.0 * Epsilon, what + "length of an unpacked normal");
  test.Expect(whole, what + "packed normals are whole numbers");
  test.ExpectAtMost(largest, 16777215.0, what + "largest packed normal, exact in float32");
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Scalar sign : { Scalar(1), Scalar(-1) })
    {
      vec3 normal(0);
      normal[axis] = sign;
      test.ExpectEqual(length(ssaoUnpackNormal(ssaoPackNormal(normal)) - normal), 0.0,
        what + "axis " + std::to_string(axis) + " stays an axis");
    }
  }
}

//------------------------------------------------------------------------------
inline void TestPositions(vtkSSAOTestMonitor& test, const std::string& what)
{
  const vec2 turned =
    ssaoTransform2(vec4(Scalar(1), Scalar(2), Scalar(3), Scalar(4)), vec2(Scalar(10), Scalar(100)));
  test.ExpectEqual(turned.x, 210.0, what + "2x2 matrix, first row");
  test.ExpectEqual(turned.y, 430.0, what + "2x2 matrix, second row");

  // Pixel (100, 50) with rays of .01 a pixel: by hand.
  const vec4 toRay(Scalar(0.01), 0, 0, Scalar(0.02));
  const vec4 toPixel(Scalar(100), 0, 0, Scalar(50));
  const vec4 offset(Scalar(-0.5), Scalar(-0.25), Scalar(0.125), Scalar(0.5));
  const vec2 slope(Scalar(0.25), Scalar(-0.5));
  const vec2 pixel(Scalar(100), Scalar(50));
  const vec3 seen = ssaoPositionVC(pixel, Scalar(4), toRay, offset, slope, Scalar(1));
  test.ExpectNear(seen.x, 0.5 * 4 + 0.25 * 4 + 0.125, 8 * Epsilon, what + "perspective x");
  test.ExpectNear(seen.y, 0.75 * 4 - 0.5 * 4 + 0.5, 8 * Epsilon, what + "perspective y");
  test.ExpectEqual(seen.z, -4.0, what + "perspective z");
  const vec3 flat = ssaoPositionVC(pixel, Scalar(4), toRay, offset, slope, Scalar(0));
  test.ExpectNear(flat.x, 0.5 + 0.25 * 4 + 0.125, 8 * Epsilon, what + "parallel x");
  test.ExpectNear(flat.y, 0.75 - 0.5 * 4 + 0.5, 8 * Epsilon, what + "parallel y");
  for (const vec3& position : { seen, flat })
  {
    const Scalar perspective = position == seen ? Scalar(1) : Scalar(0);
    const vec2 back = ssaoPixelOf(position, toPixel, offset, slope, perspective);
    test.ExpectAtMost(length(back - pixel), 1000 * Epsilon, what + "back at the pixel");
  }

  const vec3 viewer = ssaoTowardsViewer(vec3(0, Scalar(3), Scalar(-4)), Scalar(1));
  test.ExpectAtMost(length(viewer - vec3(0, Scalar(-0.6), Scalar(0.8))), 4 * Epsilon,
    what + "towards the viewer, perspective");
  test.ExpectEqual(
    length(ssaoTowardsViewer(vec3(0, Scalar(3), Scalar(-4)), Scalar(0)) - vec3(0, 0, Scalar(1))),
    0.0, what + "towards the viewer, parallel");

  // Rows 2 and 3 of glFrustum with near 1, far 3: (-2, -3), (-1, 0); and of glOrtho: (-1, -2), (0,
  // 1).
  const vec4 frustum(Scalar(-2), Scalar(-3), Scalar(-1), Scalar(0));
  const vec4 ortho(Scalar(-1), Scalar(-2), Scalar(0), Scalar(1));
  test.ExpectNear(
    ssaoDepthOfWindow(Scalar(0), frustum), 1.0, 8 * Epsilon, what + "near, perspective");
  test.ExpectNear(
    ssaoDepthOfWindow(Scalar(1), frustum), 3.0, 8 * Epsilon, what + "far, perspective");
  test.ExpectNear(
    ssaoDepthOfWindow(Scalar(0.75), frustum), 2.0, 8 * Epsilon, what + "between, perspective");
  test.ExpectNear(ssaoDepthOfWindow(Scalar(0), ortho), 1.0, 8 * Epsilon, what + "near, parallel");
  test.ExpectNear(ssaoDepthOfWindow(Scalar(1), ortho), 3.0, 8 * Epsilon, what + "far, parallel");
}

//------------------------------------------------------------------------------
inline void TestTangents(vtkSSAOTestMonitor& test, const std::string& what)
{
  double unit = 0.0;
  double upright = 0.0;
  for (const vec3& normal : Directions())
  {
    for (int i = 0; i < 16; ++i)
    {
      const double angle = i * std::acos(-1.0) / 8.0;
      vec2 rotation(Scalar(std::cos(angle)), Scalar(std::sin(angle)));
      const vec3 tangent = ssaoTangent(normal, rotation);
      unit = std::max<double>(unit, std::abs(length(tangent) - Scalar(1)));
      upright = std::max<double>(upright, std::abs(dot(tangent, normal)));
    }
    // The rotation along the normal itself.
    const Scalar across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    if (across > Scalar(0.9999999))
    {
      const vec3 tangent = ssaoTangent(normal, vec2(normal.x, normal.y));
      unit = std::max<double>(unit, std::abs(length(tangent) - Scalar(1)));
      upright = std::max<double>(upright, std::abs(dot(tangent, normal)));
    }
  }
  test.ExpectAtMost(unit, 4 * Epsilon, what + "length of a tangent");
  // Down to the limit of .0001 for the square of the part across, .01 for its length.
  test.ExpectAtMost(upright, 200 * Epsilon, what + "tangent along the normal");

  // The rotation parallel to the normal: the view direction takes its place.
  const vec3 spare = ssaoTangent(vec3(1, 0, 0), vec2(1, 0));
  test.ExpectAtMost(length(spare - vec3(0, 0, 1)), Epsilon, what + "rotation along the normal");
  const vec3 opposite = ssaoTangent(vec3(0, -1, 0), vec2(0, 1));
  test.ExpectAtMost(
    length(opposite - vec3(0, 0, 1)), Epsilon, what + "rotation against the normal");
  const vec3 tangent = ssaoTangent(vec3(0, 0, 1), vec2(Scalar(0.6), Scalar(0.8)));
  test.ExpectAtMost(length(tangent - vec3(Scalar(0.6), Scalar(0.8), 0)), 2 * Epsilon,
    what + "a surface that faces the viewer");
}

//------------------------------------------------------------------------------
inline void TestWeights(vtkSSAOTestMonitor& test, const std::string& what)
{
  // smoothstep(0, 1, R / |dz|).
  test.ExpectEqual(ssaoRangeCheck(Scalar(0), Scalar(2)), 1.0, what + "range check at 0");
  test.ExpectEqual(ssaoRangeCheck(Scalar(2), Scalar(2)), 1.0, what + "range check at R");
  test.ExpectEqual(ssaoRangeCheck(Scalar(-2), Scalar(2)), 1.0, what + "range check at -R");
  test.ExpectEqual(ssaoRangeCheck(Scalar(4), Scalar(2)), 0.5, what + "range check at 2 R");
  test.ExpectEqual(ssaoRangeCheck(Scalar(-4), Scalar(2)), 0.5, what + "range check at -2 R");
  test.ExpectEqual(ssaoRangeCheck(Scalar(8), Scalar(2)), 0.15625, what + "range check at 4 R");
  test.ExpectAtMost(
    ssaoRangeCheck(Scalar(2000), Scalar(2)), 3.1e-6, what + "range check at 1000 R");
  test.ExpectEqual(ssaoRangeCheck(Scalar(3.0e-3), Scalar(1.0e-3)),
    ssaoRangeCheck(Scalar(3), Scalar(1)), what + "range check of another scale") ||
    test.Expect(std::abs(ssaoRangeCheck(Scalar(3.0e-3), Scalar(1.0e-3)) -
                  ssaoRangeCheck(Scalar(3), Scalar(1))) < 4 * Epsilon,
      what + "or nearly");
  double before = 1.0;
  bool falls = true;
  for (int i = 1; i < 400; ++i)
  {
    const double now = ssaoRangeCheck(Scalar(i * 0.05), Scalar(1));
    falls = falls && now <= before;
    before = now;
  }
  test.Expect(falls, what + "range check falls with distance");
}

//------------------------------------------------------------------------------
// The weight by the distance from a facet's plane, against vectors.
inline void TestPlaneWeight(vtkSSAOTestMonitor& test, const std::string& what)
{
  const vec4 toRay(Scalar(0.01), 0, 0, Scalar(0.01));
  const vec4 offset(Scalar(-0.5), Scalar(-0.4), Scalar(0.125), Scalar(0.25));
  const vec2 pixel(Scalar(60.5), Scalar(30.5));
  const Scalar depth = Scalar(4);
  for (Scalar perspective : { Scalar(1), Scalar(0) })
  {
    const std::string which = what + (perspective > 0 ? "perspective, " : "parallel, ");
    const vec2 slope(Scalar(0.125), Scalar(-0.25));
    const Scalar footprint = perspective > 0 ? Scalar(0.04) : Scalar(0.01);
    const vec3 at = ssaoPositionVC(pixel, depth, toRay, offset, slope, perspective);
    double onPlane = 1.0;
    double error = 0.0;
    for (const vec3& facet : Directions())
    {
      const SsaoPlane plane =
        ssaoPlaneThrough(facet, pixel, depth, toRay, offset, slope, perspective);
      for (int i = 0; i < 9; ++i)
      {
        const vec2 moved(Scalar(i % 3 - 1) * Scalar(1.5), Scalar(i / 3 - 1) * Scalar(2));
        // Two points of the neighbour's ray; the distance is linear between them.
        const vec3 near =
          ssaoPositionVC(pixel + moved, depth, toRay, offset, slope, perspective) - at;
        const vec3 far =
          ssaoPositionVC(pixel + moved, depth + Scalar(1), toRay, offset, slope, perspective) - at;
        const Scalar rise = dot(facet, far) - dot(facet, near);
        const Scalar met = -dot(facet, near) / rise;
        if (std::abs(rise) > Scalar(0.05) && std::abs(met) < Scalar(2))
        {
          onPlane = std::min<double>(onPlane, ssaoPlaneWeight(plane, depth + met, moved));
        }
        for (Scalar deeper : { Scalar(-0.03), Scalar(-0.004), Scalar(0), Scalar(0.01) })
        {
          const vec3 neighbour =
            ssaoPositionVC(pixel + moved, depth + deeper, toRay, offset, slope, perspective);
          // In pixels, less a tenth; nothing is left at half the distance in the picture.
          const double away =
            std::max(std::abs(dot(facet, neighbour - at)) / footprint - Scalar(0.1), Scalar(0));
          const double weight = 1.0 - 2.0 * away / std::max(double(length(moved)), 1.0);
          error = std::max(error,
            std::abs(ssaoPlaneWeight(plane, depth + deeper, moved) -
              std::min(std::max(weight, 0.0), 1.0)));
        }
      }
    }
    test.ExpectEqual(onPlane, 1.0, which + "weight on the plane");
    // Depths near 4 are rounded, in half footprints of .005.
    test.ExpectAtMost(error, 4000 * Epsilon, which + "weight against vectors");

    const SsaoPlane facing =
      ssaoPlaneThrough(vec3(0, 0, 1), pixel, depth, toRay, offset, vec2(0, 0), Scalar(0));
    const vec2 moved(Scalar(3), Scalar(4));
    test.ExpectEqual(
      ssaoPlaneWeight(facing, Scalar(0), moved), 0.0, which + "weight where there is no surface");
    test.ExpectEqual(ssaoPlaneWeight(facing, depth + Scalar(0.0009), moved), 1.0,
      which + "weight a tenth of a pixel off");
    test.ExpectEqual(ssaoPlaneWeight(facing, depth - Scalar(0.0265), moved), 0.0,
      which + "weight 2.65 pixels off, 5 pixels away");
    test.Expect(ssaoPlaneWeight(facing, depth - Scalar(0.0255), moved) > Scalar(0),
      which + "weight 2.55 pixels off, 5 pixels away");
  }
}

//------------------------------------------------------------------------------
inline void TestFacets(vtkSSAOTestMonitor& test, const std::string& what)
{
  double error = 0.0;
  double largest = 0.0;
  bool sides = true;
  bool whole = true;
  for (const vec3& facet : Directions())
  {
    for (Scalar facing : { Scalar(1), Scalar(-1) })
    {
      const Scalar code = ssaoPackFacet(facet, facing);
      sides = sides && ssaoUnpackFacing(code) == facing && code != Scalar(0);
      whole = whole && std::floor(code) == code;
      error = std::max<double>(
        error, length(ssaoUnpackFacet(code) - ssaoUnpackNormal(ssaoPackNormal(facet))));
      largest = std::max<double>(largest, std::abs(code));
    }
  }
  test.ExpectEqual(error, 0.0, what + "a packed facet is a packed normal");
  test.Expect(sides, what + "a packed facet keeps the side it shows");
  test.Expect(whole, what + "packed facets are whole numbers");
  test.ExpectAtMost(largest, 16777216.0, what + "largest packed facet, exact in float32");
}

//------------------------------------------------------------------------------
inline void TestSlope(vtkSSAOTestMonitor& test, const std::string& what)
{
  // Pixels of .1 x .2 in parallel projection.
  const vec2 x(Scalar(0.1), 0);
  const vec2 y(0, Scalar(0.2));
  const vec3 at(0, 0, Scalar(-5));
  test.ExpectEqual(
    ssaoHalfPixelSlope(at, vec3(0, 0, 1), x, y, 0, 1), 0.0, what + "slope of a facing plane");
  test.ExpectNear(ssaoHalfPixelSlope(at, vec3(Scalar(0.6), 0, Scalar(0.8)), x, y, 0, 1),
    0.5 * 0.1 * 0.75, 4 * Epsilon, what + "slope of a plane tilted in x");
  test.ExpectNear(ssaoHalfPixelSlope(at, vec3(0, Scalar(-0.6), Scalar(0.8)), x, y, 0, 1),
    0.5 * 0.2 * 0.75, 4 * Epsilon, what + "slope of a plane tilted in y");
  test.ExpectNear(ssaoHalfPixelSlope(at, vec3(Scalar(0.6), 0, Scalar(0.8)), x, y, 1, 1),
    5 * 0.5 * 0.1 * 0.75, 16 * Epsilon, what + "slope in perspective grows with depth");
  test.ExpectEqual(
    ssaoHalfPixelSlope(at, vec3(1, 0, 0), x, y, 0, Scalar(0.25)), 0.25, what + "slope is limited");

  // It bounds what the plane gains within half a pixel: against the plane itself, in perspective.
  double missing = 0.0;
  for (const vec3& normal : Directions())
  {
    const vec3 position(Scalar(1), Scalar(-0.5), Scalar(-5));
    const Scalar facing = dot(normal, position);
    if (facing > Scalar(-0.5))
    {
      continue;
    }
    const Scalar slope =
      ssaoHalfPixelSlope(position, normal, x * Scalar(0.01), y * Scalar(0.01), 1, 1000);
    for (Scalar stepX : { Scalar(-0.5), Scalar(0.5) })
    {
      for (Scalar stepY : { Scalar(-0.5), Scalar(0.5) })
      {
        const vec2 ray =
          vec2(position.x, position.y) / Scalar(5) + (x * stepX + y * stepY) * Scalar(0.01);
        const Scalar depth = -facing / dot(normal, vec3(-ray.x, -ray.y, Scalar(1)));
        missing = std::max<double>(missing, (std::abs(depth - Scalar(5)) - slope) / slope);
      }
    }
  }
  test.ExpectAtMost(missing, 0.02, what + "share of a plane's gain that the slope leaves out");
}

//------------------------------------------------------------------------------
inline void TestStrength(vtkSSAOTestMonitor& test, const std::string& what)
{
  bool one = true;
  bool none = true;
  bool same = true;
  bool falls = true;
  for (int i = 0; i <= 100; ++i)
  {
    const Scalar t = Scalar(i) / Scalar(100);
    const Scalar power = Scalar(0.01) + t * Scalar(15);
    one = one && ssaoStrength(1, power, Scalar(10) * t, Scalar(10) * t, t) == Scalar(1);
    none = none && ssaoStrength(t, power, 0, Scalar(10), t) == Scalar(1);
    same = same && std::abs(ssaoStrength(t, 1, 1, 1, 0) - t) <= 2 * Epsilon;
    falls = falls &&
      ssaoStrength(t, Scalar(1.5), Scalar(0.9), 1, 0) >=
        ssaoStrength(std::max(t - Scalar(0.01), Scalar(0)), Scalar(1.5), Scalar(0.9), 1, 0);
  }
  test.Expect(one, what + "V = 1 stays 1 unless the shift is positive");
  test.Expect(none, what + "intensity 0 gives 1");
  test.Expect(same, what + "power, intensity and scale 1 and shift 0 keep V");
  test.Expect(falls, what + "strength keeps the order of V");
  test.ExpectNear(ssaoStrength(Scalar(0.5), 2, 1, 1, 0), 0.25, 4 * Epsilon, what + "power 2");
  test.ExpectNear(
    ssaoStrength(Scalar(0.5), 1, Scalar(0.5), 1, 0), 0.75, 4 * Epsilon, what + "intensity .5");
  test.ExpectNear(ssaoStrength(Scalar(0.75), 1, 1, 2, 0), 0.5, 4 * Epsilon, what + "scale 2");
  test.ExpectNear(
    ssaoStrength(Scalar(0.5), 1, 1, 1, Scalar(0.25)), 0.75, 4 * Epsilon, what + "shift .25");
  test.ExpectNear(ssaoStrength(1, 1, 1, 1, Scalar(-0.25)), 0.75, 4 * Epsilon, what + "shift -.25");
  test.ExpectNear(ssaoStrength(Scalar(0.5), 1, 1, 2, Scalar(0.25)), 0.5, 4 * Epsilon,
    what + "the shift before the scale, as vtkSSAOPass of VTK 9.6 has it");
  test.ExpectEqual(ssaoStrength(Scalar(0.1), 1, 10, 10, -1), 0.0, what + "never below 0");
  test.ExpectEqual(ssaoStrength(Scalar(2), 1, 1, 1, 0), 1.0, what + "never above 1");
  test.ExpectEqual(ssaoStrength(Scalar(-1), 1, 1, 1, 0), 0.0, what + "V below 0 counts as 0");
}

//------------------------------------------------------------------------------
// A picture of 101 x 101 pixels in parallel projection, .02 world units a pixel, the middle at
// (0, 0), over a surface of which the depth and the normal are known everywhere.
inline Estimator MakeEstimator(const std::function<vec4(vec3)>& surface)
{
  Estimator estimator;
  estimator.pixelToRay = vec4(Scalar(0.02), 0, 0, Scalar(0.02));
  estimator.rayToPixel = vec4(Scalar(50), 0, 0, Scalar(50));
  estimator.rayOffset = vec4(Scalar(-1.01), Scalar(-1.01), 0, 0);
  estimator.depthSlope = vec2(0, 0);
  estimator.viewport = vec4(0, 0, Scalar(101), Scalar(101));
  estimator.perspective = 0;
  estimator.radius = Scalar(0.5);
  estimator.bias = Scalar(0.025);
  estimator.kernelSize = 64;
  for (const glm::vec4& point : vtkSSAOHemisphereKernel(64))
  {
    estimator.kernel.emplace_back(point);
  }
  estimator.rotation = vec2(Scalar(0.6), Scalar(0.8));
  // Nearest texel, clamped to the edge.
  estimator.ssaoGeometryAt = [surface](vec2 pixel)
  {
    const Scalar x = std::floor(std::min(std::max(pixel.x, Scalar(0)), Scalar(100)));
    const Scalar y = std::floor(std::min(std::max(pixel.y, Scalar(0)), Scalar(100)));
    return surface(vec3((x - Scalar(50)) * Scalar(0.02), (y - Scalar(50)) * Scalar(0.02), 0));
  };
  return estimator;
}

inline Scalar VisibilityAt(Estimator& estimator, int x, int y)
{
  const vec2 pixel(Scalar(x) + Scalar(0.5), Scalar(y) + Scalar(0.5));
  return estimator.ssaoVisibility(pixel, estimator.ssaoGeometryAt(pixel));
}

//------------------------------------------------------------------------------
inline void TestEstimator(vtkSSAOTestMonitor& test, const std::string& what)
{
  // A plane, facing and tilted.
  for (Scalar slope : { Scalar(0), Scalar(1), Scalar(-5) })
  {
    const Scalar normal = ssaoPackNormal(normalize(vec3(slope, 0, 1)));
    Estimator plane =
      MakeEstimator([=](vec3 at) { return vec4(Scalar(10) + slope * at.x, normal, normal, 1); });
    for (int x : { 0, 50, 100 })
    {
      test.ExpectEqual(VisibilityAt(plane, x, 50), 1.0,
        what + "V of a plane of slope " + std::to_string(slope) + ", pixel " + std::to_string(x));
    }
  }

  // A right angle, both walls at 45 degrees: V falls towards the crease.
  const Scalar left = ssaoPackNormal(normalize(vec3(1, 0, 1)));
  const Scalar right = ssaoPackNormal(normalize(vec3(-1, 0, 1)));
  Estimator corner = MakeEstimator(
    [=](vec3 at) { return vec4(Scalar(10) - std::abs(at.x), at.x < 0 ? left : right, 0, 1); });
  double before = 1.0;
  double rise = 0.0;
  for (int x = 5; x < 50; ++x)
  {
    // Over all rotations of the tile.
    double mean = 0.0;
    for (const glm::vec2& rotation : vtkSSAORotationTile(4))
    {
      corner.rotation = vec2(rotation);
      mean += VisibilityAt(corner, x, 50) / 16.0;
    }
    rise = std::max(rise, mean - before);
    before = mean;
  }
  test.ExpectAtMost(before, 0.9, what + "V at the crease");
  test.ExpectAtLeast(before, 0.5, what + "V at the crease, from above");
  test.ExpectAtMost(rise, 0.003, what + "largest rise of V towards the crease");

  // A wall in front, hiding all; far in front, it counts by the range check; infinitely, not at
  // all.
  const Scalar facing = ssaoPackNormal(vec3(0, 0, 1));
  double last = -1.0;
  for (double away : { 0.6, 1.0, 2.0, 8.0, 1000.0 })
  {
    Estimator hole = MakeEstimator(
      [=](vec3 at)
      {
        const bool center = std::abs(at.x) < Scalar(0.001) && std::abs(at.y) < Scalar(0.001);
        return vec4(center ? Scalar(2000) : Scalar(2000 - away), facing, facing, 1);
      });
    const double v = VisibilityAt(hole, 50, 50);
    const double weight = ssaoRangeCheck(Scalar(away), hole.radius);
    // Points within the hole of one pixel see the bottom.
    test.ExpectNear(1.0 - v, weight, 0.25 * weight + 1.0e-6,
      what + "occlusion by a wall " + std::to_string(away) + " in front");
    test.Expect(v > last, what + "and less than that by a nearer one");
    last = v;
  }

  // Background: depth 0, hides nothing.
  Estimator island = MakeEstimator(
    [=](vec3 at)
    {
      const bool center = std::abs(at.x) < Scalar(0.001) && std::abs(at.y) < Scalar(0.001);
      return center ? vec4(Scalar(10), facing, facing, 1) : vec4(0);
    });
  test.ExpectEqual(VisibilityAt(island, 50, 50), 1.0, what + "V before the background");

  // Outside the viewport nothing is known: half of a wall in view hides as much as all of it. The
  // texture goes on there, with another viewport's surface.
  Estimator half = MakeEstimator([=](vec3 at)
    { return vec4(at.x > Scalar(-0.001) ? Scalar(10) : Scalar(9.5), facing, facing, 1); });
  const double open = VisibilityAt(half, 50, 50);
  half.viewport = vec4(0, 0, Scalar(51), Scalar(101));
  const double cut = VisibilityAt(half, 50, 50);
  test.ExpectNear(open, 0.5, 0.15, what + "V with a wall on one side");
  // The same samples are hidden, of fewer; those in the column of the pixel itself stay open.
  test.ExpectAtLeast((1.0 - cut) / (1.0 - open), 1.3,
    what + "occlusion with only that side in the viewport, against both");
  half.viewport = vec4(Scalar(50), 0, Scalar(51), Scalar(101));
  test.ExpectEqual(VisibilityAt(half, 50, 50), 1.0, what + "V with the other side in the viewport");
  half.viewport = vec4(Scalar(200), 0, Scalar(51), Scalar(101));
  test.ExpectEqual(VisibilityAt(half, 50, 50), 1.0, what + "V without any known sample");

  // Behind the eye nothing is known either, in perspective.
  Estimator close = MakeEstimator([=](vec3) { return vec4(Scalar(0.01), facing, facing, 1); });
  close.perspective = 1;
  test.ExpectEqual(VisibilityAt(close, 50, 50), 1.0, what + "V of a plane nearer than the radius");
}

//------------------------------------------------------------------------------
inline void TestAll(vtkSSAOTestMonitor& test, const std::string& what)
{
  TestNormals(test, what);
  TestPositions(test, what);
  TestTangents(test, what);
  TestWeights(test, what);
  TestPlaneWeight(test, what);
  TestFacets(test, what);
  TestSlope(test, what);
  TestStrength(test, what);
  TestEstimator(test, what);
}
}
