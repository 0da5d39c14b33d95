# SPDX-License-Identifier: BSD-3-Clause
# ssao_make_meshes(<folder>): writes small files of many formats, and broken ones, as text.

function (ssao_make_meshes folder)
  # A square with a tetrahedron on it.
  set(points 0 0 0 4 0 0 4 4 0 0 4 0 1 1 0.1 3 1 0.1 2 3 0.1 2 2 2)
  set(triangles 0 1 2 0 2 3 4 5 7 5 6 7 6 4 7)
  list(JOIN points " " point_text)
  list(JOIN triangles " " triangle_text)
  set(obj_text "")
  set(ply_text "")
  set(stl_text "")
  set(vtk_text "")
  foreach (i RANGE 0 21 3)
    list(SUBLIST points ${i} 3 point)
    list(JOIN point " " point)
    string(APPEND obj_text "v ${point}\n")
    string(APPEND ply_text "${point}\n")
  endforeach ()
  foreach (i RANGE 0 12 3)
    list(SUBLIST triangles ${i} 3 triangle)
    set(obj_face "f")
    string(APPEND stl_text "facet normal 0 0 0\nouter loop\n")
    foreach (corner IN LISTS triangle)
      math(EXPR number "${corner} + 1")
      math(EXPR first "3 * ${corner}")
      string(APPEND obj_face " ${number}")
      list(SUBLIST points ${first} 3 point)
      list(JOIN point " " point)
      string(APPEND stl_text "vertex ${point}\n")
    endforeach ()
    string(APPEND obj_text "${obj_face}\n")
    string(APPEND stl_text "endloop\nendfacet\n")
    list(JOIN triangle " " triangle)
    string(APPEND ply_text "3 ${triangle}\n")
    string(APPEND vtk_text "3 ${triangle}\n")
  endforeach ()
  file(WRITE "${folder}/mesh.obj" "${obj_text}")
  file(WRITE "${folder}/mesh.stl" "solid mesh\n${stl_text}endsolid mesh\n")
  set(ply_head "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
    "property float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n")
  string(CONCAT ply_head ${ply_head})
  file(WRITE "${folder}/mesh.ply" "${ply_head}${ply_text}")
  string(SUBSTRING "${ply_text}" 0 60 half)
  file(WRITE "${folder}/cut.ply" "${ply_head}${half}")
  file(WRITE "${folder}/mesh.vtk" "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\n"
    "POINTS 8 float\n${point_text}\nPOLYGONS 5 20\n${vtk_text}")

  foreach (bad nan outside)
    set(bad_points "${point_text}")
    set(bad_triangles "${triangle_text}")
    if (bad STREQUAL nan)
      string(REPLACE "4 4 0" "4 nan 0" bad_points "${point_text}")
    else ()
      string(REPLACE "0 1 2" "0 1 99" bad_triangles "${triangle_text}")
    endif ()
    file(WRITE "${folder}/${bad}.vtp" "<VTKFile type=\"PolyData\"><PolyData>"
      "<Piece NumberOfPoints=\"8\" NumberOfPolys=\"5\">"
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">"
      "${bad_points}</DataArray></Points>"
      "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">"
      "${bad_triangles}</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 6 9 12 15</DataArray></Polys>"
      "</Piece></PolyData></VTKFile>\n")
  endforeach ()
  file(WRITE "${folder}/no_points.vtp" "<VTKFile type=\"PolyData\"><PolyData>"
    "<Piece NumberOfPoints=\"0\" NumberOfPolys=\"0\"><Points/><Polys/></Piece>"
    "</PolyData></VTKFile>\n")
  file(WRITE "${folder}/cut.vtp" "<VTKFile type=\"PolyData\"><PolyData>\n<Piece NumberOfPoints=")

  file(WRITE "${folder}/mesh.vtu" "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>"
    "<Piece NumberOfPoints=\"8\" NumberOfCells=\"2\">"
    "<PointData Scalars=\"height\">"
    "<DataArray type=\"Float32\" Name=\"height\" format=\"ascii\">0 1 2 1 1 2 3 4</DataArray>"
    "</PointData>"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">"
    "${point_text}</DataArray></Points>"
    "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">"
    "4 5 6 7 0 1 2 3</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4 8</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10 9</DataArray></Cells>"
    "</Piece></UnstructuredGrid></VTKFile>\n")

  # The squared distance from the middle of 5 x 5 x 5 points: contours are balls.
  set(values "")
  foreach (z RANGE -2 2)
    foreach (y RANGE -2 2)
      foreach (x RANGE -2 2)
        math(EXPR value "${x} * ${x} + ${y} * ${y} + ${z} * ${z}")
        string(APPEND values "${value} ")
      endforeach ()
    endforeach ()
  endforeach ()
  file(WRITE "${folder}/volume.vti" "<VTKFile type=\"ImageData\">"
    "<ImageData WholeExtent=\"0 4 0 4 0 4\" Origin=\"0 0 0\" Spacing=\"1 1 1\">"
    "<Piece Extent=\"0 4 0 4 0 4\"><PointData Scalars=\"distance\">"
    "<DataArray type=\"Float32\" Name=\"distance\" format=\"ascii\">${values}</DataArray>"
    "</PointData></Piece></ImageData></VTKFile>\n")

  file(WRITE "${folder}/empty.obj" "")
  file(WRITE "${folder}/no_faces.obj" "# a comment\n")
  file(WRITE "${folder}/text.stl" "This is not a mesh.\n")
  file(WRITE "${folder}/text.pdb" "This is not a molecule.\n")
  file(WRITE "${folder}/text.gltf" "This is not a scene.\n")
  file(WRITE "${folder}/mesh.xyz" "0 0 0\n")
endfunction ()
