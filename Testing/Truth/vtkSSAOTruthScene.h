// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthScene
 * @brief   The opaque surfaces that VTK draws for a renderer, as triangles and spheres.
 *
 * Gathers from the visible opaque props of a vtkRenderer what their mappers would send to OpenGL:
 * the same triangles (vtkOpenGLIndexBufferObject makes them), the same winding, the same normals
 * (point normals unless the interpolation is flat, else cell normals, else none), the same matrices
 * (assemblies, user matrices, glyph matrices) and clipping planes. Spheres drawn as impostors
 * (vtkOpenGLSphereMapper), and glyphs of a whole vtkSphereSource, are true spheres.
 *
 * Mappers understood: vtkPolyDataMapper, the composite polydata mapper, vtkDataSetMapper,
 * vtkGlyph3DMapper and vtkOpenGLSphereMapper. Others are left out and named by GetSkipped().
 * Props without valid bounds are left out, since VTK's culler drops them (points without cells).
 * Lines, points, wireframes, edges, volumes and 2D props are no surfaces and are left out.
 * Surfaces without lighting hide what is behind them, but neither receive nor cast occlusion.
 *
 * Two things are not as VTK draws them: an impostor that the near plane cuts, which VTK draws whole
 * with a depth of 0, and the outline of impostors that are near compared with their radius, which
 * VTK's billboard cuts off.
 *
 * Nothing is rendered and no OpenGL context is needed. Coordinates are double, world axes, relative
 * to an origin: the camera's position (its focal point for a parallel projection), so that a scene
 * far from the world's origin keeps its precision.
 */

#ifndef vtkSSAOTruthScene_h
#define vtkSSAOTruthScene_h

#include <array>
#include <string>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkGlyph3DMapper;
class vtkMapper;
class vtkMatrix4x4;
class vtkOpenGLSphereMapper;
class vtkPolyData;
class vtkRenderer;

class vtkSSAOTruthScene
{
public:
  /**
   * The triangles of one drawn polydata, or of all glyphs with the same source.
   */
  struct Mesh
  {
    /// What a mesh is shaded with.
    enum NormalType
    {
      NoNormals,    ///< shade with the facet's own normal
      PointNormals, ///< three values per point
      CellNormals   ///< three values per triangle
    };

    std::vector<double> Points;          ///< three per point, relative to the origin
    std::vector<unsigned int> Triangles; ///< three point numbers each, in VTK's winding
    std::vector<double> Normals;         ///< world axes, any length
    NormalType Normal = NoNormals;       ///< what Normals holds
    bool Lit = true;                     ///< else it only hides what is behind
    bool CullsBack = false;              ///< back faces are not drawn; they still occlude
    bool CullsFront = false;             ///< front faces are not drawn; they still occlude

    /// Each keeps the points with n.x + d >= 0, x relative to the origin.
    std::vector<std::array<double, 4>> ClippingPlanes;
  };

  /**
   * True spheres, drawn as impostors or as glyphs.
   */
  struct Spheres
  {
    std::vector<double> Centers; ///< three per sphere, relative to the origin
    std::vector<double> Radii;   ///< one per sphere
    bool Lit = true;             ///< else they only hide what is behind
  };

  /**
   * Whether glyphs of a whole vtkSphereSource become the true spheres (the default), or the
   * triangles that are drawn. Flat-shaded and non-uniformly scaled glyphs are always triangles.
   */
  void SetTrueSphereGlyphs(bool trueSphereGlyphs) { this->TrueSphereGlyphs = trueSphereGlyphs; }

  /**
   * Replaces the contents by the opaque surfaces of a renderer. Brings their pipelines up to date.
   */
  void Gather(vtkRenderer* renderer);

  /**
   * World coordinates of the origin that all points are relative to.
   */
  const double* GetOrigin() const { return this->Origin; }

  ///@{
  /**
   * What was gathered.
   */
  const std::vector<Mesh>& GetMeshes() const { return this->Meshes; }
  const std::vector<Spheres>& GetSpheres() const { return this->SphereSets; }
  ///@}

  ///@{
  /**
   * Number of triangles, and of spheres.
   */
  std::size_t GetNumberOfTriangles() const;
  std::size_t GetNumberOfSpheres() const;
  ///@}

  /**
   * Class names of the mappers that were not understood; their props are missing.
   */
  const std::vector<std::string>& GetSkipped() const { return this->Skipped; }

  /**
   * Digest of all geometry, normals and flags.
   */
  std::string GetDigest() const;

private:
  struct DrawnSurface;

  void AddActor(vtkActor* actor, vtkMatrix4x4* matrix);
  void AddMapper(vtkActor* actor, vtkMapper* mapper, const double matrix[16]);
  void AddPolyData(vtkActor* actor, vtkMapper* mapper, vtkPolyData* data, const double matrix[16]);
  bool AddComposite(vtkActor* actor, vtkMapper* mapper, const double matrix[16]);
  void AddSphereImpostors(vtkActor* actor, vtkOpenGLSphereMapper* mapper, const double matrix[16]);
  void AddGlyphs(vtkActor* actor, vtkGlyph3DMapper* mapper, const double matrix[16]);
  void AddGlyphsOf(
    vtkActor* actor, vtkGlyph3DMapper* mapper, vtkDataSet* points, const double matrix[16]);
  void SetDrawing(vtkActor* actor, vtkMapper* mapper, Mesh& mesh) const;
  void AppendInstance(const DrawnSurface& surface, const double matrix[16],
    const double normalMatrix[9], Mesh& mesh) const;

  double Origin[3] = { 0.0, 0.0, 0.0 };
  bool TrueSphereGlyphs = true;
  std::vector<Mesh> Meshes;
  std::vector<Spheres> SphereSets;
  std::vector<std::string> Skipped;
};

#endif
