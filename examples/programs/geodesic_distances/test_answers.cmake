# Answers are right, or say what is not as it was asked for.
include(${CMAKE_CURRENT_LIST_DIR}/test_meshes.cmake)

# Runs the program on `input`, and fails unless it ends well and prints what the regular expression
# matches.
function(answer text)
  expect(0 "${text}" ${PROGRAM} ${ARGN} --force)
endfunction()

# lengths of paths: along the edges, and straight on
answer("\n3 +1 +2\n" square.off -s 3 -t 1)
answer("\n3 +1 +1.4142135" square.off -s 3 -t 1 -e 0)
answer("\n3 +1 +1.4142135" square.off -s 3 -t 1 -e 0.1)
answer("\n3 +1 +1.4142135" square.off -s 3 -t 1 --straighten)
answer("\n0.25,0.75,0 +0.75,0.25,0 +0.7071067" square.off -s 0.25,0.75,0 -t 0.75,0.25,0 -e 0)
answer("--sources -3,0,0: the nearest point of the surface is 0 0 0, 3 away" square.off -s -3,0,0)
file(WRITE ${folder}/list.txt "0 # a comment\n2\n")
answer("\n0 +1 +1\n0 +3 +1\n" square.off -s file:list.txt -t 1 3)
answer("\n1 +0 +1\n2 +3 +1\n" square.off -s 1 2 -t 0 3 -s 2 -m 5 --statistics)
answer("exact distances, by CGAL .*vertices below the exact distance +0\n" square.off -e 0.1
       -s 3 --compare)

# targets that no path leads to keep their lines
answer("\n0 +1 +1\nnone +4 +inf\n0 +2 +1\n" two_parts.off -t 1 4 2)
answer("There is no path to target 4: " two_parts.off -t 1 4 2)
expect_contents(geodesic_distances.polylines.txt "^2 [^\n]+\ninf\n2 [^\n]+\n$")
answer("\nnone +2 +inf\n" square.off -t 2 -m 0.5)

# from curves
answer("\ncurve +3 +1\ncurve +2 +1\n" square.off --curve 0 1 -t 3 2 -e 0)
answer("\ncurve +3 +0.7071067" square.off --curve 0 2 -t 3 -e 0.1)
answer("\ncurve +3 +1\n" square.off --curve 0 1 -t 3)
file(WRITE ${folder}/middle.txt "2 0 0.25 0 1 0.25 0 # from border to border\n")
answer("\ncurve +3 +0.75\n" square.off --curve polyline:middle.txt -t 3 -e 0)
answer("distance, smallest +-0.75\n" square.off --curve polyline:middle.txt -e 0 --signed --csv)
expect_contents(geodesic_distances.csv "\n0,0,0,0,0.25,0\n1,1,0,0,0.25,0\n2,1,1,0,-0.75,0\n3,0,1,0,-0.75,0\n$")
answer("Written: .*_offsets.vtp geodesic_distances_offsets.polylines.txt"
       square.off --curve 0 1 -e 0 --offset 0.25 0.5 0.75)
expect_contents(geodesic_distances_offsets.vtp "NumberOfLines=\"3\"")
expect_contents(geodesic_distances_offsets.polylines.txt "^[0-9]+ 1 0.25 0 [^\n]* 0 0.25 0\n[0-9]+ 1 0.5 0 ")
answer("_offsets.vtp" square.off --curve polyline:middle.txt -e 0 --signed --offset step:0.25)
answer("--offset: there are none at 1 of the distances, such as 7; " square.off -e 0 --offset 0.5 7)
answer("_offsets.vtp" square.off -e 0 -s 0.25,0.25,0 --offset count:3)

# one question needs no more arcs than the search meets
answer("arcs are computed +by the search\n" square.off -e 0.1 --statistics)

# files that had to be repaired, and what was done
answer("edges cut that had more than two faces: 1, such as that of vertices 0 and 1; vertices duplicated"
       fan_of_three.off)
answer("connected components: 3\\." fan_of_three.off)
answer("points merged with others in the same place: 2, such as vertex 3 with vertex 0\\. Vertices and"
       doubled_points.off)
answer("Vertices without faces, which no path leads to: 1, such as vertex 6\\." doubled_points.off)
answer("Some faces are not triangles: they are triangulated" quadrangle.off)

# a bound that takes longer than the exact answer
answer("--epsilon 1e-09: .*--epsilon 0 is exact" square.off -e 1e-9)

# costs
file(WRITE ${folder}/weights.txt "3\n5 # the other face\n")
answer("\n0 +1 +3\n" square.off -e 0.1 -w weights.txt -t 1)
file(WRITE ${folder}/weights.ply
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
     "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
     "property float cost\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n")
answer("\n0 +1 +7\n" weights.ply -e 0.1 -w property:cost -t 1 -o from_weights)
file(WRITE ${folder}/edges.txt "0 2\n")
answer("\nnone +1 +inf\n3 +2 +1\n" square.off -e 0.1 -b edges.txt -s 3 -t 1 2)
file(WRITE ${folder}/one.txt "1\n")
answer("bound that holds, epsilon" needle.off -e 0.01 -w one.txt --accept-weaker-bound)

# graphs in files
answer("arcs are computed +in advance\n.*Written: .* graph\n" square.off -e 0.1 --save-graph graph)
answer("bound that holds, epsilon +0.1\n.*\n3 +1 +1.4142135" square.off --load-graph graph -s 3 -t 1)
expect(1 "--load-graph graph: .* 4 vertices, this one has 6" ${PROGRAM} two_parts.off --load-graph graph --force)

# files
answer("Written: all.ply all.vtp all_paths.vtp all.polylines.txt all_isolines.vtp all.csv\n"
       square.off -o all -t 2 --csv -i 0.5 1)
expect_contents(all.csv "^vertex,x,y,z,distance,nearest_source\n0,0,0,0,0,0\n1,1,0,0,1,0\n2,1,1,0,")
expect_contents(all_isolines.vtp "NumberOfLines=\"2\"")
answer("there are none at 2 of the distances, such as 7; those of vertices go from 0 to 1.41421\\."
       square.off -o all -i 7 1 8)
expect_contents(all_isolines.vtp "NumberOfLines=\"1\"")
answer("there are none at 1 of the distances, such as 0.1; those of vertices go from 0.35"
       square.off -s 0.75,0.25,0 -i 0.1 -e 0)
answer("_isolines.vtp" square.off -i count:3)
expect_contents(geodesic_distances_isolines.vtp "NumberOfLines=\"3\"")
expect(1 "exists; --force replaces it" ${PROGRAM} square.off -o all)

# of an earlier run, nothing stays that could pass for a result of this one
answer("Written: all.ply" square.off -o all -t 2 --csv -i 0.5 1)
file(REMOVE ${folder}/all.ply ${folder}/all.vtp ${folder}/all_paths.vtp ${folder}/all.csv)
expect(1 "--output: all.polylines.txt exists, of an earlier run; --force removes it" ${PROGRAM}
       square.off -o all --csv)
answer("Removed, as it was of an earlier run: all.polylines.txt\nRemoved, [^\n]*: all_isolines.vtp\n"
       square.off -o all --csv)
foreach(name all.polylines.txt all_isolines.vtp)
  if(EXISTS ${folder}/${name})
    message(FATAL_ERROR "${name} is there")
  endif()
endforeach()

# what others may have written is not removed
set(not_ours "exists, which this run does not write, and may be no file of an earlier run")
file(WRITE ${folder}/all.png "a texture\n")
expect(1 "--output: all.png ${not_ours}" ${PROGRAM} square.off -o all --csv --force)
expect_contents(all.png "^a texture\n$")
file(REMOVE ${folder}/all.png)
file(WRITE ${folder}/all.csv "a table\n")
expect(1 "--output: all.csv ${not_ours}" ${PROGRAM} square.off -o all --force)
expect_contents(all.csv "^a table\n$")
answer("Written: [^\n]* all.csv\n" square.off -o all --csv)
answer("Removed, as it was of an earlier run: all.csv\n" square.off -o all)
file(MAKE_DIRECTORY ${folder}/all_isolines.vtp)
expect(1 "--output: all_isolines.vtp ${not_ours}" ${PROGRAM} square.off -o all --force)

# the halfedges of vertices, and so the graph, do not depend on the way in which the mesh is made
set(grid "")
set(faces "")
foreach(j RANGE 4)
  foreach(i RANGE 4)
    list(APPEND grid "${i} ${j} 0.${i}${j}")
    math(EXPR a "5 * ${j} + ${i}")
    math(EXPR b "${a} + 1")
    math(EXPR c "${a} + 6")
    math(EXPR d "${a} + 5")
    if(i LESS 4 AND j LESS 4)
      list(APPEND faces "3 ${a} ${b} ${c}" "3 ${a} ${c} ${d}")
    endif()
  endforeach()
endforeach()
write_mesh(grid.off "${grid}" "${faces}")
write_mesh(grid_and_face_twice.off "${grid}" "${faces};3 0 1 6")
foreach(name grid grid_and_face_twice)
  answer("Written: " ${name}.off -e 0.1 --save-graph ${name}.graph -o ${name} --csv)
endforeach()
expect_same(grid.graph grid_and_face_twice.graph)
expect_same(grid.csv grid_and_face_twice.csv)

# names that end like those of files
answer("Written: out.ply out.vtp out_paths.vtp\n" square.off -o out.ply)
answer("Written: out.ply out.vtp out_paths.vtp out.csv\n" square.off -o out.csv)
answer("Written: out.ply out.vtp out_paths.vtp\n" square.off -o out_paths.vtp)
answer("Written: out.ply out.vtp out_paths.vtp out_isolines.vtp\n" square.off -o out_isolines.vtp -i 0.5)
expect(1 "--output: isolines are the lines at --isolines" ${PROGRAM} square.off -o out_isolines.vtp --force)
expect(1 "--output: offsets are the curves at --offset" ${PROGRAM} square.off -o out_offsets.polylines.txt --force)
expect(1 "--output: polylines are the paths to --targets" ${PROGRAM} square.off -o out.polylines.txt --force)

# colors, of near vertices and far ones: uniform ones are dark and light
expect(1 "--colors: .gray. is neither rainbow nor uniform" ${PROGRAM} square.off --colors gray)
answer("Written: " square.off -o rainbow)
answer("Written: " square.off -o uniform --colors uniform)
file(READ ${folder}/rainbow.ply rainbow HEX)
file(READ ${folder}/uniform.ply uniform HEX)
if(rainbow STREQUAL uniform)
  message(FATAL_ERROR "--colors changes nothing")
endif()

expect(1 "--output: weights.ply is a file that is read" ${PROGRAM} weights.ply -o weights --force)
