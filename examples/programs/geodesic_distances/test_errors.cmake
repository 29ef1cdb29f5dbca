# What the user gets wrong is refused with the name of the argument and the reason, before anything is
# written; or is told, where it does not make an answer wrong.
include(${CMAKE_CURRENT_LIST_DIR}/test_meshes.cmake)
file(GLOB meshes RELATIVE ${CMAKE_CURRENT_BINARY_DIR}/${folder} ${folder}/*)

# Fails unless the program refuses its arguments with one line, which begins with the regular
# expression.
function(refuse text)
  expect(1 "^geodesic_distances: ${text}[^\n]*\n$" ${PROGRAM} ${ARGN})
endfunction()

# options that are not there, or have no value
refuse("unrecognised option '--nonsense'" square.off --nonsense)
refuse("unrecognised option '--eps'" square.off --eps 0.1) # abbreviations
refuse("no mesh given")
refuse("more than one mesh is given: square.off and needle.off" square.off needle.off)
refuse("--output: a value must follow" square.off --output)
refuse("--epsilon: a value must follow" square.off --epsilon=)
refuse("--epsilon: a value must follow, in place of --targets" square.off --epsilon --targets 2)
refuse("--sources: a value must follow" square.off -s)
refuse("option '--epsilon' cannot be specified more than once" square.off -e 1 -e 2)

expect(0 "^geodesic_distances \\(Approximate Geodesics\\) [0-9.]+\n$" ${PROGRAM} --version)

# files
refuse("cannot read missing.off: No such file or directory" missing.off)
refuse("cannot read .: it is a folder" .)
refuse("cannot read a mesh from empty.off: it is empty" empty.off)
refuse("cannot read a mesh from empty.stl: it is empty" empty.stl)
refuse("cannot read a mesh from text.off: it does not begin with OFF" text.off)
refuse("cannot read a mesh from square: its file name extension must be .off, " square)
refuse("cannot read a mesh from not_a_number.off: line 3: vertex 0 does not have three finite coordinates"
       not_a_number.off)
refuse("the mesh in no_faces.off has no faces" no_faces.off)
refuse("the mesh in edge.obj has no face with three vertices" edge.obj)
refuse("cannot read a mesh from wrong_index.off: line 7: face 0 has vertex 7; .*there are 4"
       wrong_index.off)
refuse("cannot read a mesh from wrong_index.ply: face 0 has vertex 3; .*there are 3" wrong_index.ply)
execute_process(COMMAND id -u OUTPUT_VARIABLE user)
if(user GREATER 0) # root may read everything
  file(CHMOD ${folder}/text.off PERMISSIONS OWNER_WRITE)
  refuse("cannot read text.off: Permission denied" text.off)
  file(CHMOD ${folder}/text.off PERMISSIONS OWNER_READ OWNER_WRITE)
endif()

# places
refuse("--sources 4: there is no vertex 4: the mesh has 4 vertices" square.off -s 4)
refuse("--targets 9: there is no vertex 9" square.off -t 0 9)
refuse("--sources -1: " square.off -s -1)
refuse("--sources 1.5: " square.off -s 1.5)
refuse("--sources random:5: the mesh has 4 vertices" square.off -s random:5)
refuse("--sources one: .one. is not the index of a vertex, nor x,y,z, random:K, file:NAME or polyline:NAME"
       square.off -s one)
refuse("--sources random:0: a number of vertices from 1 on must follow, as in random:5" square.off
       -s random:0)
refuse("--sources random:x: a number of vertices from 1 on must follow" square.off -s random:x)
refuse("--sources file:list.txt: cannot read list.txt: No such file" square.off -s file:list.txt)
file(WRITE ${folder}/list.txt "0\n1 4 # the latter is not there\n")
refuse("--sources file:list.txt: line 2: there is no vertex 4" square.off -s file:list.txt)
file(REMOVE ${folder}/list.txt)
refuse("--targets 0,0: three numbers are needed" square.off -t 0,0)
refuse("--targets 0,0,nan: three numbers are needed" square.off -t 0,0,nan)
refuse("--seed: \"-1\" is not a whole number" square.off -s random:2 --seed -1)

# numbers
refuse("--epsilon: .abc. is not a number" square.off -e abc)
refuse("--epsilon: .nan. is not a number" square.off -e nan)
refuse("--epsilon: it is -1, and must be" square.off -e -1)
refuse("--epsilon: it is inf, and must be" square.off -e inf)
refuse("--epsilon: it is 5, which would let paths be more than twice as long .* 0.05 stands for 5 %"
       square.off -e 5)
refuse("--maximum-distance: it is -2, and must be" square.off -m -2)
refuse("--maximum-distance: .nan. is not a number" square.off -m nan)
refuse("--isolines: .nan. is not a number" square.off -i nan)
refuse("--isolines: count:0: " square.off -i count:0)

refuse("--offset: these curves are exact, and need --epsilon 0" square.off --offset 1)
refuse("--offset: these curves are exact, and need --epsilon 0" square.off -e 0.1 --offset 1)
refuse("--offset: a curve at distance 0" square.off -e 0 --offset 0)
refuse("--offset: it is -1, and must be" square.off -e 0 --offset -1)
refuse("--offset: step:0: a number above 0 must follow" square.off -e 0 --offset step:0)
refuse("--offset: step:1: a number above 0 must follow, and no more" square.off -e 0 --offset step:1 2)
refuse("--offset: these are more than 100000 distances; the largest is 1.4" square.off -e 0 --offset step:1e-9)

# curves
refuse("--curve: it takes the place of --sources; both are given" square.off -s 0 --curve 0 1)
refuse("--signed: it is for --curve" square.off --signed)
refuse("--curve 9: there is no vertex 9" square.off --curve 0 9)
refuse("--curve polyline:list.txt: cannot read list.txt: No such file" square.off --curve polyline:list.txt)
foreach(text "" "2 0 0 0\n" "0 0 0\n" "1 0 0 x\n" "1 0 0 0\n1 0 0 0\n" "1e300 0 0\n")
  file(WRITE ${folder}/list.txt "${text}")
  refuse("--curve polyline:list.txt: " square.off --curve polyline:list.txt)
endforeach()
file(WRITE ${folder}/x.polylines.txt "1 0 0 0\n")
refuse("--output: x.polylines.txt is a file that is read" square.off -o x -t 1 --curve polyline:x.polylines.txt --force)
file(REMOVE ${folder}/list.txt ${folder}/x.polylines.txt)
refuse("--curve: .*no path joins points 0 and 1 of a curve" two_parts.off --curve 0 4 -e 0)
refuse(".*source 0 has no sides, as it is a point" square.off --curve 0 -e 0 --signed)
refuse(".*source 0 has no two sides: it is not closed" square.off --curve 0.4,0.1,0 0.6,0.1,0 -e 0 --signed)

# pictures
refuse("--view: it is for --picture" square.off --view 0 0 y)
refuse("--view: it takes an azimuth" square.off --picture --view foo)
refuse("--view: .foo. is not a number" square.off --picture --view foo 0 y)
refuse("--view: the axis that points up is .w." square.off --picture --view 0 0 w)
expect(1 "--picture: the program xvfb-run is needed" ${CMAKE_COMMAND} -E env PATH=/nowhere ${PROGRAM}
       square.off --picture)

# what does not go together
refuse("--weights: it needs --epsilon E with E above 0" square.off -w weights.txt)
refuse("--barriers: it needs --epsilon E with E above 0" square.off -e 0 -b edges.txt)
refuse("--straighten: it is for the paths to --target" square.off --straighten)
refuse("--straighten: cheapest paths" square.off -e 1 -w weights.txt -t 1 --straighten)
refuse("--accept-weaker-bound: it is for" square.off -e 1 --accept-weaker-bound)
refuse("--compare: exact distances know neither" square.off -e 1 -b edges.txt --compare)
refuse("--compare: the sources must be vertices" square.off -s 0,0,0 --compare)
refuse("--compare: CGAL's Surface_mesh_shortest_path knows no curves" square.off --curve 0 1 --compare)
refuse("--save-graph: it needs --epsilon" square.off -e 0 --save-graph graph)
refuse("--load-graph: the graph has its own bound" square.off -e 1 --load-graph graph)

# costs
refuse("--weights: cannot read weights.txt: No such file" square.off -e 1 -w weights.txt)
refuse("--weights property:cost: square.off is not a PLY file" square.off -e 1 -w property:cost)
refuse("--weights property:cost: the faces of colors.ply have no property cost that is a number" colors.ply
       -e 1 -w property:cost)
refuse("--weights property:vertex_indices: the faces of colors.ply have no property vertex_indices that is"
       colors.ply -e 1 -w property:vertex_indices)
file(WRITE ${folder}/weights.txt "1\n-2 # a comment\n")
refuse("--weights weights.txt: line 2: \"-2\" is not a weight" square.off -e 1 -w weights.txt)
file(WRITE ${folder}/weights.txt "1 2 3\n")
refuse("--weights weights.txt: there are 3 weights, and the mesh has 2 faces" square.off -e 1 -w
       weights.txt)
file(WRITE ${folder}/edges.txt "# a comment\n0 2\n1 3\n")
refuse("--barriers edges.txt: line 3: there is no edge between the vertices 1 and 3" square.off -e 1
       -b edges.txt)
file(WRITE ${folder}/edges.txt "0\n")
refuse("--barriers edges.txt: line 1: the indices of two vertices" square.off -e 1 -b edges.txt)
file(WRITE ${folder}/weights.txt "1\n")
refuse("--epsilon: for this --epsilon, the face with vertices .*--accept-weaker-bound" needle.off -e 0.01 -w
       weights.txt)

# graphs
refuse("--load-graph: cannot read graph: No such file" square.off --load-graph graph)
refuse("--load-graph text.off: .*is not that of a discrete geodesic graph" square.off --load-graph text.off)

# output
refuse("cannot write nowhere/x.ply: No such file or directory" square.off -o nowhere/x)
foreach(name . .. folder/ folder/..)
  refuse("--output: .*is no name that files can begin with; .*as in folder/bunny" square.off --output ${name})
endforeach()
file(MAKE_DIRECTORY ${folder}/folder.csv)
refuse("cannot write folder.csv: Is a directory" square.off -o folder --csv --force)
refuse("--output: folder.csv exists; --force replaces it" square.off -o folder --csv)
file(WRITE ${folder}/square.ply "of somebody else")
refuse("--output: square.ply exists; --force replaces it" square.off -o square)
expect_contents(square.ply "^of somebody else$")
refuse("cannot read missing.off: No such file or directory" missing.off -o square) # comes first
refuse("--save-graph: x.vtp is a file of --output, too" square.off -o x -e 0.1 --save-graph x.vtp)
refuse("--save-graph: text.off exists; --force replaces it" square.off -o x -e 0.1 --save-graph text.off)
file(WRITE ${folder}/x.csv "1\n1\n")
refuse("--output: x.csv is a file that is read" square.off -o x -e 0.1 --csv -w x.csv --force)
file(REMOVE ${folder}/square.ply ${folder}/x.csv)

file(WRITE ${folder}/huge.txt "1\n1e400\n")
refuse("--weights huge.txt.*.1e400. is not a weight" square.off -e 0.1 -w huge.txt)
file(REMOVE ${folder}/huge.txt)
file(REMOVE_RECURSE ${folder}/folder.csv)
expect_files(edges.txt ${meshes} weights.txt)
