# Small meshes that the tests of geodesic_distances write into their folder.
include(${CMAKE_CURRENT_LIST_DIR}/../command_line/test_helpers.cmake)

# Writes an OFF file: points and faces are lists of texts.
function(write_mesh name points faces)
  list(LENGTH points number_of_points)
  list(LENGTH faces number_of_faces)
  string(REPLACE ";" "\n" lines "OFF\n${number_of_points} ${number_of_faces} 0;${points};${faces}")
  file(WRITE ${folder}/${name} "${lines}\n")
endfunction()

set(square "0 0 0;1 0 0;1 1 0;0 1 0")
write_mesh(square.off "${square}" "3 0 1 2;3 0 2 3")
write_mesh(two_parts.off "0 0 0;1 0 0;0 1 0;5 0 0;6 0 0;5 1 0" "3 0 1 2;3 3 4 5")
write_mesh(fan_of_three.off "0 0 0;1 0 0;0 1 0;0 -1 0;0 0 1" "3 0 1 2;3 0 1 3;3 0 1 4")
write_mesh(doubled_points.off "0 0 0;1 0 0;1 1 0;0 0 0;1 1 0;0 1 0;7 7 7" "3 0 1 2;3 3 4 5")
write_mesh(quadrangle.off "${square}" "4 0 1 2 3")
# a square among points that no face has, and others that are in the same place, or not in a face
write_mesh(mended.off "9 9 9;0 0 0;1 0 0;5 5 5;1 1 0;0 0 0;0 1 0;7 7 7" "3 1 2 4;3 1 5 2;3 5 4 6")
write_mesh(needle.off "0 0 0;1 0 0;0.5 1e-30 0" "3 0 1 2")
write_mesh(not_a_number.off "0 0 nan;1 0 0;0 1 0" "3 0 1 2")
write_mesh(no_faces.off "${square}" "")
write_mesh(wrong_index.off "${square}" "3 0 1 7")
file(WRITE ${folder}/wrong_index.ply
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
     "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
     "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")
file(WRITE ${folder}/colors.ply
     "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
     "property double z\nelement face 2\nproperty uchar red\nproperty uchar green\n"
     "property uchar blue\nproperty list uchar ushort vertex_indices\nend_header\n"
     "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 5 9 3 0 1 2\n7 5 2 3 0 2 3\n")
file(WRITE ${folder}/empty.off "")
file(WRITE ${folder}/empty.stl "")
file(WRITE ${folder}/edge.obj "v 0 0 0\nv 1 0 0\nf 1 2\n")
file(WRITE ${folder}/square "a name without an ending\n")
file(WRITE ${folder}/text.off "This is no mesh.\n")
