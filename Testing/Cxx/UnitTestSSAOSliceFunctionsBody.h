// SPDX-License-Identifier: BSD-3-Clause

// Included by UnitTestSSAOSliceFunctions.cxx once for each precision, within a namespace; no
// include guard.

namespace inPrecision
{
constexpr Scalar Epsilon = std::numeric_limits<Scalar>::epsilon();

//------------------------------------------------------------------------------
// Directions all over the sphere.
inline std::vector<vec3> Sphere(int count)
{
  std::vector<vec3> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - 2.0 * (i + 0.5) / count;
    const double angle = 2.399963229728653 * i;
    const double across = std::sqrt(1.0 - z * z);
    directions.push_back(normalize(
      vec3(Scalar(across * std::cos(angle)), Scalar(across * std::sin(angle)), Scalar(z))));
  }
  return directions;
}

// The frame of the slices as the estimators make it.
struct Frame
{
  vec3 viewer, across, up;
  explicit Frame(const vec3& towards)
    : viewer(towards)
    , across(normalize(cross(vec3(0, 1, 0), towards)))
    , up(cross(towards, across))
  {
  }
};

inline vec2 Turn(double angle)
{
  return vec2(Scalar(std::cos(angle)), Scalar(std::sin(angle)));
}

//------------------------------------------------------------------------------
inline void TestArcCosine(vtkSSAOTestMonitor& test, const std::string& what)
{
  double error = 0.0;
  bool falls = true;
  Scalar before = Scalar(4);
  for (int i = -10000; i <= 10000; ++i)
  {
    const Scalar x = Scalar(i) / Scalar(10000);
    const Scalar angle = ssaoArcCosine(x);
    error = std::max<double>(error, std::abs(angle - std::acos(double(x))));
    falls = falls && angle <= before + Epsilon * 4;
    before = angle;
  }
  // The bound that Abramowitz and Stegun state, 6.7e-5, and rounding.
  test.ExpectAtMost(error, 7.0e-5, what + "error of the arc cosine");
  test.Expect(falls, what + "the arc cosine falls");
  test.ExpectEqual(ssaoArcCosine(Scalar(1)), 0.0, what + "arc cosine of 1");
  test.Expect(std::isfinite(ssaoArcCosine(Scalar(1) + Epsilon)), what + "arc cosine just above 1");
  test.Expect(std::isfinite(ssaoArcCosine(Scalar(-1) - Epsilon)), what + "and just below -1");

  const vec2 turned = ssaoTurned(Turn(0.3), Turn(0.5));
  test.ExpectAtMost(length(turned - Turn(0.8)), 4 * Epsilon, what + "error of a turned direction");
}

//------------------------------------------------------------------------------
inline void TestArcMeasure(vtkSSAOTestMonitor& test, const std::string& what)
{
  double error = 0.0;
  double nearError = 0.0;
  double complete = 0.0;
  for (int i = -36; i <= 36; ++i)
  {
    const double n = i * Pi / 36.0;
    const Scalar normalCosine = Scalar(std::cos(n));
    const Scalar normalSine = Scalar(std::sin(n));
    for (int j = 0; j <= 180; ++j)
    {
      const double h = j * Pi / 180.0;
      const Scalar cosine = Scalar(std::cos(h));
      const double exact = ArcByQuadrature(h, n);
      error =
        std::max(error, std::abs(exact - double(ssaoArcMeasure(cosine, normalCosine, normalSine))));
      nearError = std::max(
        nearError, std::abs(exact - double(ssaoArcMeasureNear(cosine, normalCosine, normalSine))));
    }
    if (std::abs(n) < Pi / 2.0)
    {
      // All that a normal sees in a slice, to both sides: cos(n) + n sin(n).
      const Scalar sum = ssaoArcMeasure(-normalSine, normalCosine, normalSine) +
        ssaoArcMeasure(normalSine, normalCosine, -normalSine);
      complete = std::max(complete, std::abs(double(sum) - std::cos(n) - n * std::sin(n)));
    }
  }
  // Half the error of the arc cosine and rounding.
  test.ExpectAtMost(error, 1.0e-4, what + "arc measure against quadrature");
  test.ExpectAtMost(complete, 1.0e-4, what + "arc measure of all that a normal sees");
  // What its comment promises.
  test.ExpectAtMost(nearError, 6.0e-4, what + "arc measure without roots against quadrature");
}

//------------------------------------------------------------------------------
// What facet and normal leave open, against directions walked step by step.
inline void TestSlices(vtkSSAOTestMonitor& test, const std::string& what)
{
  double square = 0.0;
  double weight = 0.0;
  double angle = 0.0;
  double limit = 0.0;
  int walked = 0;
  int beyond = 0;
  bool nothingOpen = true;
  for (const vec3& viewer : { vec3(0, 0, 1), normalize(vec3(Scalar(0.4), Scalar(-0.3), 1)) })
  {
    const Frame frame(viewer);
    for (const vec3& normal : Sphere(60))
    {
      for (const vec3& facet : Sphere(40))
      {
        if (dot(facet, viewer) < Scalar(0.02) || dot(normal, facet) < Scalar(0.3))
        {
          continue;
        }
        for (int i = 0; i < 5; ++i)
        {
          const SsaoSlice slice =
            ssaoSlice(frame.across, frame.up, viewer, normal, facet, Turn(0.1 + i * Pi / 5.0));
          square = std::max<double>(square, std::abs(dot(slice.along, viewer)));
          square = std::max<double>(square, std::abs(length(slice.along) - Scalar(1)));
          const vec3 inSlice =
            viewer * dot(normal, viewer) + slice.along * dot(normal, slice.along);
          weight = std::max<double>(weight, std::abs(slice.weight - length(inSlice)));
          if (slice.weight < Scalar(0.05))
          {
            continue;
          }
          const vec3 rebuilt = viewer * slice.normalCosine + slice.along * slice.normalSine;
          angle = std::max<double>(angle, length(rebuilt - normalize(inSlice)));
          if (dot(normal, viewer) < Scalar(0))
          {
            ++beyond;
            nothingOpen = nothingOpen &&
              (slice.normalSine >= Scalar(0) ? slice.lowestBehind : slice.lowestAhead) == Scalar(1);
            continue;
          }
          for (int side : { 1, -1 })
          {
            // Down from the viewer's direction as long as both normals leave it open.
            double lowest = 0.0;
            const double step = Pi / 4000.0;
            for (double phi = 0.0; phi <= Pi; phi += step)
            {
              const vec3 direction =
                viewer * Scalar(std::cos(phi)) + slice.along * Scalar(side * std::sin(phi));
              if (dot(direction, normal) < Scalar(0) || dot(direction, facet) < Scalar(0))
              {
                break;
              }
              lowest = phi;
            }
            const Scalar got = side > 0 ? slice.lowestAhead : slice.lowestBehind;
            limit = std::max(
              limit, std::abs(std::acos(double(clamp(got, Scalar(-1), Scalar(1)))) - lowest));
            ++walked;
          }
        }
      }
    }
  }
  test.ExpectAtLeast(walked, 5000, what + "sides of slices");
  test.ExpectAtLeast(beyond, 500, what + "slices whose normal looks away");
  test.ExpectAtMost(square, 8 * Epsilon, what + "slices are square to the viewer's direction");
  test.ExpectAtMost(weight, 8 * Epsilon, what + "weight against the projected normal's length");
  test.ExpectAtMost(angle, 200 * Epsilon, what + "projected normal from its cosine and sine");
  // One step of the walk; in single precision the arc cosine near 0 and 180 degrees adds
  // sqrt(epsilon).
  test.ExpectAtMost(limit, Pi / 4000.0 + 3.0 * std::sqrt(double(Epsilon)),
    what + "lowest open angle of a side, against a walk");
  test.Expect(nothingOpen,
    what + "a normal that looks away from the viewer leaves nothing open on the other side");
}

//------------------------------------------------------------------------------
// A floor and an endless wall of height H at distance d: V = 1 - (1 - 1 / sqrt(1 + (H / d)^2)) / 2.
inline void TestCorner(vtkSSAOTestMonitor& test, const std::string& what)
{
  const vec3 floor = normalize(vec3(Scalar(0.1), 1, Scalar(0.2)));
  const vec3 wall = normalize(cross(floor, vec3(1, 0, Scalar(-0.5)))); // towards the wall
  double error = 0.0;
  int views = 0;
  for (double steepness : { 0.1, 0.5, 1.0, 3.0, 20.0 })
  {
    const double exact = 1.0 - 0.5 * (1.0 - 1.0 / std::sqrt(1.0 + steepness * steepness));
    for (const vec3& viewer : Sphere(60))
    {
      // Where the point is seen from: above the floor and not through the wall.
      if (dot(viewer, floor) < Scalar(0.05) ||
        dot(viewer, floor) < Scalar(steepness) * dot(viewer, wall) + Scalar(0.01) ||
        std::abs(viewer.y) > Scalar(0.999))
      {
        continue;
      }
      ++views;
      const Frame frame(viewer);
      double visible = 0.0;
      double open = 0.0;
      const int slices = 256;
      for (int i = 0; i < slices; ++i)
      {
        const SsaoSlice slice =
          ssaoSlice(frame.across, frame.up, viewer, floor, floor, Turn((i + 0.5) * Pi / slices));
        for (int side : { 1, -1 })
        {
          // The angle at which the slice crosses the plane through the point and the wall's edge.
          const vec3 along = slice.along * Scalar(side);
          const vec3 edge = floor - wall * Scalar(steepness);
          double phi = std::atan2(dot(viewer, edge), -dot(along, edge));
          phi = phi < 0.0 ? phi + Pi : phi;
          const vec3 direction = viewer * Scalar(std::cos(phi)) + along * Scalar(std::sin(phi));
          const bool met = dot(direction, wall) > Scalar(0) && dot(direction, floor) > Scalar(0);
          const Scalar lowest = side > 0 ? slice.lowestAhead : slice.lowestBehind;
          const Scalar horizon = met ? max(Scalar(std::cos(phi)), lowest) : lowest;
          const Scalar sine = slice.normalSine * Scalar(side);
          visible += slice.weight * ssaoArcMeasure(horizon, slice.normalCosine, sine);
          open += slice.weight * ssaoArcMeasure(lowest, slice.normalCosine, sine);
        }
      }
      error = std::max(error, std::abs(visible / open - exact));
    }
  }
  test.ExpectAtLeast(views, 60, what + "views of the corner");
  // The arc cosine's error, and where the horizon leaves the wall's edge between two slices.
  test.ExpectAtMost(
    error, 1.0e-3, what + "V in a corner from the exact horizon, against closed form");
}

//------------------------------------------------------------------------------
inline void TestRays(vtkSSAOTestMonitor& test, const std::string& what)
{
  double cosineError = 0.0;
  double distanceError = 0.0;
  double traceError = 0.0;
  int above = 0;
  int below = 0;
  bool lowestHolds = true;
  const vec4 pixelToRay(Scalar(0.002), Scalar(0.0001), Scalar(-0.0002), Scalar(0.0021));
  const Scalar determinant = pixelToRay.x * pixelToRay.w - pixelToRay.y * pixelToRay.z;
  const vec4 rayToPixel =
    vec4(pixelToRay.w, -pixelToRay.y, -pixelToRay.z, pixelToRay.x) / determinant;
  const vec4 rayOffset(Scalar(-0.3), Scalar(-0.2), Scalar(0.05), Scalar(0.02));
  for (int k = 0; k < 2; ++k)
  {
    const Scalar perspective = Scalar(k);
    const vec2 depthSlope(Scalar(k ? 0.0 : 0.1), Scalar(k ? 0.0 : -0.2));
    for (const vec3& facet : Sphere(30))
    {
      for (int i = 0; i < 60; ++i)
      {
        const vec2 pixel(Scalar(40 + 7 * (i % 11)) + Scalar(0.5), Scalar(90) + Scalar(0.5));
        const vec2 other = pixel + vec2(Scalar(i % 7 * 5 - 14), Scalar(i % 5 * 9 - 17));
        const Scalar depth = Scalar(3);
        const Scalar t = Scalar(0.05) * Scalar(i % 13 - 6) + Scalar(0.013);
        const vec3 from =
          ssaoPositionVC(pixel, depth, pixelToRay, rayOffset, depthSlope, perspective);
        const vec3 to =
          ssaoPositionVC(other, depth + t, pixelToRay, rayOffset, depthSlope, perspective);
        const vec3 viewer = ssaoTowardsViewer(from, perspective);
        const vec2 centerRay =
          (ssaoTransform2(pixelToRay, pixel) + vec2(rayOffset.x, rayOffset.y)) * perspective +
          depthSlope;
        const SsaoRay ray = ssaoRayOf(
          ssaoTransform2(pixelToRay, other - pixel), depth, centerRay, facet, viewer, perspective);
        const vec3 offset = to - from;
        const Scalar distance = length(offset);
        distanceError = std::max<double>(
          distanceError, std::abs(ssaoSquaredDistance(ray, t) / (distance * distance) - Scalar(1)));
        const Scalar cosine = dot(offset, viewer) / distance;
        const Scalar rise = dot(offset, facet) / distance;
        const Scalar got = ssaoCosineAt(ray, t, Scalar(-1));
        if (rise > Scalar(0.011))
        {
          ++above;
          cosineError = std::max<double>(cosineError, std::abs(got - cosine));
          lowestHolds = lowestHolds && ssaoCosineAt(ray, t, Scalar(0.99999)) >= Scalar(0.99999);
        }
        else if (rise < Scalar(0.009))
        {
          ++below;
          lowestHolds = lowestHolds && got == Scalar(-1);
        }
      }
    }
  }
  test.ExpectAtLeast(above, 1000, what + "samples above the facet");
  test.ExpectAtLeast(below, 1000, what + "samples below the facet");
  // Positions of size 3 are subtracted at distances from .03 on: a hundred times the rounding,
  // and twice that for the square.
  test.ExpectAtMost(distanceError, 800 * Epsilon, what + "squared distance along a ray, relative");
  test.ExpectAtMost(cosineError, 400 * Epsilon, what + "cosine of a sample, against vectors");
  test.Expect(lowestHolds, what + "what lies on the facet or under it is the lowest angle");

  // The trace of a slice: where a small step along it is seen.
  for (int k = 0; k < 2; ++k)
  {
    const Scalar perspective = Scalar(k);
    const vec2 depthSlope(0, 0);
    const vec2 pixel(Scalar(70.5), Scalar(130.5));
    const vec3 from = ssaoPositionVC(pixel, Scalar(3), pixelToRay,
      vec4(Scalar(-0.3), Scalar(-0.2), 0, 0), depthSlope, perspective);
    const Frame frame(ssaoTowardsViewer(from, perspective));
    for (int i = 0; i < 12; ++i)
    {
      const SsaoSlice slice = ssaoSlice(
        frame.across, frame.up, frame.viewer, frame.viewer, frame.viewer, Turn(i * Pi / 12.0));
      const Scalar step = Scalar(0.01);
      const vec2 seen = ssaoPixelOf(from + slice.along * step, rayToPixel,
        vec4(Scalar(-0.3), Scalar(-0.2), 0, 0), depthSlope, perspective);
      const vec2 trace = ssaoTrace(slice, from, rayToPixel, perspective) * step;
      traceError = std::max<double>(traceError, length(seen - pixel - trace) / length(trace));
    }
  }
  // The step of .01 at depth 3 is not quite infinitesimal; pixels near 130 are rounded.
  test.ExpectAtMost(
    traceError, 1.0e-3 + 3000 * double(Epsilon), what + "trace of a slice, relative");
}

//------------------------------------------------------------------------------
// What a radius covers at most bounds the traces of all slices, and some slice comes near it.
inline void TestLargestReach(vtkSSAOTestMonitor& test, const std::string& what)
{
  const vec4 pixelToRay(Scalar(0.004), 0, 0, Scalar(0.004));
  const vec4 rayToPixel(250, 0, 0, 250);
  for (double perspective : { 0.0, 1.0 })
  {
    double beyond = 0.0;
    double unreached = 0.0;
    for (const vec2& ray : { vec2(0), vec2(Scalar(0.4), 0), vec2(Scalar(-1.2), Scalar(0.9)) })
    {
      const Scalar depth = 3;
      const vec3 positionVC(ray.x * depth, ray.y * depth, -depth);
      const Frame frame(ssaoTowardsViewer(positionVC, Scalar(perspective)));
      double longest = 0.0;
      for (int i = 0; i < 360; ++i)
      {
        const SsaoSlice slice = ssaoSlice(
          frame.across, frame.up, frame.viewer, frame.viewer, frame.viewer, Turn(i * Pi / 180.0));
        const vec2 trace =
          ssaoTrace(slice, positionVC, rayToPixel, Scalar(perspective)) * Scalar(0.7);
        longest = std::max(longest, double(length(trace)));
      }
      const vec2 direction = ssaoRayThrough(
        ssaoTransform2(rayToPixel, ray), pixelToRay, vec4(0), vec2(0), Scalar(perspective));
      const double largest =
        ssaoLargestReach(Scalar(0.7), depth, direction, rayToPixel, Scalar(perspective));
      beyond = std::max(beyond, longest / largest - 1.0);
      unreached = std::max(unreached, 1.0 - longest / largest);
    }
    test.ExpectAtMost(
      beyond, 8 * Epsilon, what + "share by which a trace is longer than the bound");
    // Half a degree off the longest at most.
    test.ExpectAtMost(unreached, 0.0002, what + "share by which the longest trace is shorter");
  }
}

//------------------------------------------------------------------------------
inline void TestSampleShare(vtkSSAOTestMonitor& test, const std::string& what)
{
  bool rises = true;
  bool inside = true;
  double nearest = 100.0;
  for (double reach : { 0.5, 1.3, 4.0, 50.0, 3000.0 })
  {
    for (int count : { 1, 2, 6, 12, 64 })
    {
      double before = 0.0;
      for (int i = 0; i < 10 * count; ++i)
      {
        const double share = ssaoSampleShare(Scalar(i) / Scalar(10), Scalar(count), Scalar(reach));
        rises = rises && share >= before;
        inside = inside && share > 0.0 && share <= 1.0;
        nearest = reach > 1.3 ? std::min(nearest, share * reach) : nearest;
        before = share;
      }
    }
  }
  test.Expect(rises, what + "samples follow each other outwards");
  test.Expect(inside, what + "samples lie within the radius");
  test.ExpectAtLeast(nearest, 1.3 - 2 * Epsilon, what + "pixels to the nearest sample");
  test.ExpectNear(ssaoSampleShare(Scalar(3), Scalar(6), Scalar(1.0e6)), 0.25, 0.001,
    what + "half of the samples lie within a quarter of the radius");
  // Otherwise samples would be taken twice.
  test.ExpectAtLeast(50.0 *
      (ssaoSampleShare(Scalar(1), Scalar(8), Scalar(50)) -
        ssaoSampleShare(Scalar(0), Scalar(8), Scalar(50))),
    1.0, what + "pixels from the first sample to the second");
}

//------------------------------------------------------------------------------
inline void TestShareInside(vtkSSAOTestMonitor& test, const std::string& what)
{
  const vec4 viewport(Scalar(10), Scalar(20), Scalar(100), Scalar(50));
  const auto share = [&](double x, double y, double reachX, double reachY)
  {
    return double(ssaoShareInside(
      vec2(Scalar(x), Scalar(y)), vec2(Scalar(reachX), Scalar(reachY)), viewport, Scalar(1)));
  };
  test.ExpectEqual(share(60, 45, 20, -20), 1.0, what + "a trace inside the viewport");
  test.ExpectNear(share(60, 45, 100, 0), 0.5, Epsilon, what + "a trace across the right border");
  test.ExpectNear(share(60, 45, -80, 0), 0.625, Epsilon, what + "a trace across the left border");
  test.ExpectNear(share(60, 45, 30, 100), 0.25, Epsilon, what + "a trace across the upper border");
  test.ExpectNear(share(60, 45, 3, -40), 0.625, Epsilon, what + "a trace across the lower border");
  test.ExpectEqual(
    share(60, 69.5, 0, 40), 0.0, what + "a trace that leaves before its first sample");
  test.ExpectEqual(share(60, 69.5, 0, 0.4), 1.0, what + "a short trace at the border");
  test.ExpectEqual(share(60, 45, 0, 0), 1.0, what + "no trace");
}

//------------------------------------------------------------------------------
// The stretches of a ray as vtkSSAOPass1SolidsFS.glsl makes them of its layers.
inline SsaoSolids Solids(const std::vector<double>& layers, double sheet)
{
  int inside = 0;
  for (double layer : layers)
  {
    inside = ssaoInsideAfter(inside, Scalar(layer));
  }
  const Scalar pairs = layers.size() >= 5 && inside > 0 ? Scalar(1) : Scalar(0);
  SsaoSolids solids = ssaoNoSolids();
  for (double layer : layers)
  {
    solids = ssaoAddLayer(solids, Scalar(layer), Scalar(sheet), pairs);
  }
  // What is not there changes nothing.
  solids = ssaoAddLayer(solids, Scalar(0), Scalar(sheet), pairs);
  // What goes on does so to the end of the reach, 10, behind the first surface.
  const double end =
    layers.size() == 1 ? 1.0e30 : std::abs(layers.empty() ? 0.0 : layers[0]) + 10.0;
  return ssaoCloseSolids(solids, Scalar(end), Scalar(sheet), pairs);
}

inline void ExpectSolids(vtkSSAOTestMonitor& test, const std::string& what,
  const std::vector<double>& layers, const std::vector<double>& wanted)
{
  const SsaoSolids solids = Solids(layers, 0.25);
  const vec4 first = solids.first;
  const vec4 second = solids.second;
  const double got[] = { first.x, first.y, first.z, first.w, second.x, second.y, second.z,
    second.w };
  bool same = true;
  std::ostringstream text;
  for (std::size_t i = 0; i < 8; ++i)
  {
    same = same && got[i] == double(Scalar(i < wanted.size() ? wanted[i] : 0.0));
    text << (i ? " " : "") << got[i];
  }
  test.Expect(same, what + " (got " + text.str() + ")");
}

inline void TestSolids(vtkSSAOTestMonitor& test, const std::string& what)
{
  const double endless = 1.0e30;
  ExpectSolids(test, what + "no layer, nothing solid", {}, {});
  ExpectSolids(test, what + "+-: solid between", { 2, -3 }, { 2, 3 });
  ExpectSolids(test, what + "++--: nested bodies are one", { 1, 2, -3, -4 }, { 1, 4 });
  ExpectSolids(test, what + "+-+-: two bodies", { 1, -2, 3, -4 }, { 1, 2, 3, 4 });
  ExpectSolids(
    test, what + "++-+--: overlapping bodies are one", { 1, 2, -3, 4, -5, -6 }, { 1, 6 });
  ExpectSolids(test, what + "+-+-+-+-: four bodies", { 1, -2, 3, -4, 5, -6, 7, -8 },
    { 1, 2, 3, 4, 5, 6, 7, 8 });
  ExpectSolids(test, what + "+: a terrain goes on", { 5 }, { 5, endless });
  ExpectSolids(test, what + "+-+: a body before a terrain", { 1, -2, 5 }, { 1, 2, 5, 11 });
  ExpectSolids(
    test, what + "+-+: a terrain out of reach is a sheet", { 1, -2, 50 }, { 1, 2, 50, 50.25 });
  ExpectSolids(
    test, what + "-: an exit without an entry is a sheet before it", { -2 }, { 1.75, 2 });
  ExpectSolids(test, what + "-+: then nothing goes on", { -2, 3 }, { 1.75, 2, 3, 3.25 });
  ExpectSolids(test, what + "-+-: sheet and body", { -2, 3, -4 }, { 1.75, 2, 3, 4 });
  ExpectSolids(test, what + "++: two sheets", { 1, 2 }, { 1, 1.25, 2, 2.25 });
  ExpectSolids(test, what + "+-++-: five layers that do not close are paired", { 1, -2, 3, 4, -5 },
    { 1, 2, 3, 3.25, 4, 5 });
  ExpectSolids(test, what + "+-+-+: of five the last is a sheet", { 1, -2, 3, -4, 5 },
    { 1, 2, 3, 4, 5, 5.25 });
  ExpectSolids(test, what + "+++++: five sheets, of which four are kept", { 1, 2, 3, 4, 5 },
    { 1, 1.25, 2, 2.25, 3, 3.25, 4, 4.25 });

  int inside = 0;
  for (double layer : { 1.0, 2.0, 0.0, -3.0, -4.0, -5.0 })
  {
    inside = ssaoInsideAfter(inside, Scalar(layer));
    test.Expect(inside >= 0 && inside <= 2, what + "solids a ray is inside of");
  }
  test.ExpectEqual(inside, 0.0, what + "solids a ray is inside of after all are left");

  // From a surface of the same facing: as they are. From one of the other: what lies between.
  const Scalar sheet = Scalar(0.25);
  const auto expectSeen = [&](const std::string& which, vec4 solids, vec4 more, double facing,
                            const std::vector<double>& wanted)
  {
    const SsaoStretches seen = ssaoStretchesSeen(solids, more, Scalar(facing), sheet);
    const double got[] = { seen.first.x, seen.first.y, seen.second.x, seen.second.y, seen.third.x,
      seen.third.y };
    bool same = true;
    std::ostringstream text;
    for (std::size_t i = 0; i < 6; ++i)
    {
      // A stretch that is not there has the front 0, its back does not matter.
      same = same && (got[i] == wanted[i] || (i % 2 == 1 && wanted[i - 1] == 0.0));
      text << (i ? " " : "") << got[i];
    }
    test.Expect(same, what + which + " (got " + text.str() + ")");
  };
  const vec4 two(4, 5, 7, 8);
  const vec4 third(9, 10, 0, 0);
  expectSeen("seen from a front", two, third, 1, { 4, 5, 7, 8, 9, 10 });
  expectSeen("backs seen from a back", vec4(-4, 5, 7, 8), third, -1, { 4, 5, 7, 8, 9, 10 });
  expectSeen("fronts seen from a back: what lies between", two, third, -1, { 3.75, 4, 5, 7, 8, 9 });
  expectSeen("backs seen from a front", vec4(-4, 5, 7, 8), third, 1, { 3.75, 4, 5, 7, 8, 9 });
  expectSeen("one body seen from a back: behind it a sheet", vec4(4, 5, 0, 0), vec4(0), -1,
    { 3.75, 4, 5, 5.25, 0, 0 });
  expectSeen("a terrain seen from a back: a sheet", vec4(4, Scalar(1.0e30), 0, 0), vec4(0), -1,
    { 3.75, 4, 0, 0, 0, 0 });
  expectSeen("nothing seen from a front", vec4(0), vec4(0), 1, { 0, 0, 0, 0, 0, 0 });
  expectSeen("nothing seen from a back", vec4(0), vec4(0), -1, { 0, 0, 0, 0, 0, 0 });
  expectSeen("a sheet does not reach the eye", vec4(Scalar(0.125), Scalar(0.5), 0, 0), vec4(0), -1,
    { 0.0625, 0.125, 0.5, 0.75, 0, 0 });
}

//------------------------------------------------------------------------------
// Sectors of arcs, against the exact measure: whatever the normal and the arc.
inline void TestSectors(vtkSSAOTestMonitor& test, const std::string& what)
{
  Estimator estimator{};
  bool counted = true;
  for (int i = 0; i <= 30; ++i)
  {
    counted = counted && estimator.ssaoNumberOfSectors((1 << i) - 1) == i &&
      estimator.ssaoNumberOfSectors(((1 << 30) - 1) ^ ((1 << i) - 1)) == 30 - i;
  }
  counted = counted && estimator.ssaoNumberOfSectors(0x15555555) == 15;
  test.Expect(counted, what + "number of sectors");

  bool within = true;
  double error = 0.0;     // of the hidden measure, one dither
  double meanError = 0.0; // over nine dithers
  for (int i = -89; i <= 89; ++i)
  {
    const double n = i * Pi / 180.0;
    const Scalar normalCosine = Scalar(std::cos(n));
    const Scalar normalSine = Scalar(std::sin(n));
    // As ssaoSlice has it with the facet along the normal, and tilted off it.
    for (double tilt : { 0.0, 0.3, 1.0 })
    {
      const Scalar lowest = -min(normalSine, Scalar(std::sin(n - tilt)));
      const double end = std::acos(std::min(std::max(double(lowest), -1.0), 1.0));
      const double whole = ArcByQuadrature(end, n);
      const typename Estimator::SsaoSide side =
        estimator.ssaoSide(vec2(1, 0), lowest, normalCosine, normalSine, Scalar(1));
      for (int first = 0; first <= 20; ++first)
      {
        for (int last = first; last <= 20; ++last)
        {
          const double from = end * first / 20.0;
          const double to = end * last / 20.0;
          const vec3 arc(1, max(Scalar(std::cos(from)), lowest), max(Scalar(std::cos(to)), lowest));
          const double exact = ArcByQuadrature(to, n) - ArcByQuadrature(from, n);
          double mean = 0.0;
          for (int dither = 0; dither < 9; ++dither)
          {
            const int sectors = estimator.ssaoSectorsOf(
              arc, normalCosine, normalSine, side.sectorsPerMeasure, Scalar((dither + 0.5) / 9.0));
            const bool good = sectors >= 0 && sectors < (1 << 30);
            // Where nearly nothing is open it hardly matters what is hidden.
            within = within && (good || whole < 0.002);
            const double measure =
              estimator.ssaoNumberOfSectors(sectors) / double(side.sectorsPerMeasure);
            error = std::max(error, std::abs(measure - exact) - whole / 30.0);
            mean += measure / 9.0;
          }
          meanError = std::max(meanError, std::abs(mean - exact) - whole / 270.0);
        }
      }
    }
  }
  test.Expect(within, what + "sectors lie among 30, where anything is open");
  // Both ends of an arc and the whole side have the error of the measure without roots, .0006.
  test.ExpectAtMost(error, 0.0024, what + "hidden measure beyond one sector's error");
  test.ExpectAtMost(meanError, 0.0024, what + "hidden measure, mean over the dither");
}

//------------------------------------------------------------------------------
// Fetches of one pixel of a plane that faces the viewer, where the radius covers 200 pixels.
template <typename AnyEstimator>
inline int CountFetches(vtkScreenSpaceAmbientOcclusionPass* preset)
{
  AnyEstimator estimator{};
  estimator.viewport = vec4(0, 0, 800, 600);
  estimator.drawn = estimator.viewport;
  estimator.pixelToRay = vec4(Scalar(0.001), 0, 0, Scalar(0.001));
  estimator.rayToPixel = vec4(1000, 0, 0, 1000);
  estimator.rayOffset = vec4(Scalar(-0.4), Scalar(-0.3), 0, 0);
  estimator.solidsPlace = vec4(2, 2, 0, 0);
  estimator.sliceTurn = vec2(0, 1);
  estimator.perspective = 1;
  estimator.radius = 1;
  estimator.sheet = Scalar(0.1);
  estimator.directions = preset->GetDirections();
  estimator.steps = preset->GetSteps();
  const vec3 towardsViewer(0, 0, 1);
  estimator.ssaoVisibility(
    vec2(400, 300), vec4(5, ssaoPackNormal(towardsViewer), ssaoPackFacet(towardsViewer, 1), 1));
  return estimator.fetches;
}

//------------------------------------------------------------------------------
// The budgets that the documentation names: fetches of an estimated pixel, its own geometry among
// them.
inline void TestFetchBudgets(vtkSSAOTestMonitor& test, const std::string& what)
{
  vtkNew<vtkScreenSpaceAmbientOcclusionPass> preset;
  preset->SetQualityToFast();
  test.ExpectEqual(1 + CountFetches<ExactHorizon>(preset), 18, what + "fetches of Fast");
  preset->SetQualityToBalanced();
  test.ExpectEqual(1 + CountFetches<Estimator>(preset), 43, what + "fetches of Balanced");
  preset->SetQualityToAccurate();
  test.ExpectEqual(1 + CountFetches<Estimator>(preset), 59, what + "fetches of Accurate");
}

//------------------------------------------------------------------------------
inline void TestAll(vtkSSAOTestMonitor& test, const std::string& what)
{
  TestArcCosine(test, what);
  TestArcMeasure(test, what);
  TestSlices(test, what);
  TestCorner(test, what);
  TestRays(test, what);
  TestLargestReach(test, what);
  TestSampleShare(test, what);
  TestShareInside(test, what);
  TestSolids(test, what);
  TestSectors(test, what);
  TestFetchBudgets(test, what);
}
}
