# Vertices and faces have the numbers of the file, whatever is repaired.
include(${CMAKE_CURRENT_LIST_DIR}/test_meshes.cmake)

function(answer text)
  expect(0 "${text}" ${PROGRAM} ${ARGN} --force)
endfunction()

# isolated vertices first, in between and last; two vertices in one place; a face without area
answer("\n6 +2 +1.4142135" mended.off -s 6 -t 2 -e 0)
answer("\n6 +2 +2\n" mended.off -s 6 -t 2)
answer("\n5 +2 +1\n5 +1 +0\nnone +3 +inf\n" mended.off -s 5 -t 2 1 3)
answer("vertices +8\n" mended.off -s 1)
answer("vertices reached +5\n" mended.off -s 1)
answer("points merged with others in the same place: 1, such as vertex 5 with vertex 1; faces removed that" mended.off)
answer("were degenerate or duplicates: 1, such as face 1\\. Vertices and faces keep the numbers" mended.off)
answer("Vertices without faces, which no path leads to: 3, such as vertex 0\\." mended.off)
answer("--sources 0: vertex 0 has no faces, so no path leads from or to it\\." mended.off)
answer("vertices reached +1\n" mended.off -s 0)

set(rows "0,9,9,9,inf,-1;1,0,0,0,0,1;2,1,0,0,1,1;3,5,5,5,inf,-1;4,1,1,0,1,0;5,0,0,0,0,1;6,0,1,0,0,0;7,7,7,7,inf,-1")
list(JOIN rows "\n" rows)
file(WRITE ${folder}/list.txt "6\n5 # which is in the place of 1\n")
answer("Written: " mended.off -s file:list.txt -e 0 --csv -o mended)
expect_contents(mended.csv "^vertex,x,y,z,distance,nearest_source\n${rows}\n$")
expect_contents(mended.vtp "NumberOfPoints=\"8\"")
expect_contents(mended.ply "element vertex 8\n")
expect_contents(mended_paths.vtp "Name=\"name\" NumberOfTuples=\"2\" format=\"ascii\">\n54 0 53 0 \n")
answer("Written: " mended.off -s random:4 -o mended)
expect(1 "--sources random:5: the mesh has 4 vertices" ${PROGRAM} mended.off -s random:5 -o none)
expect(1 "--sources 8: there is no vertex 8: the mesh has 8 vertices" ${PROGRAM} mended.off -s 8 -o none)

# barriers and weights
file(WRITE ${folder}/edges.txt "5 4\n")
answer("\nnone +2 +inf\n6 +1 +1\n" mended.off -s 6 -t 2 1 -e 0.1 -b edges.txt)
file(WRITE ${folder}/weights.txt "3\n1000\n5\n")
answer("\n1 +2 +3\n" mended.off -s 1 -t 2 -e 0.1 -w weights.txt)
file(WRITE ${folder}/weights.txt "5\n1000\n3\n")
answer("\n1 +6 +3\n" mended.off -s 1 -t 6 -e 0.1 -w weights.txt)
file(WRITE ${folder}/weights.txt "7\n")
answer("\n0 +1 +7\n" quadrangle.off -t 1 -e 0.1 -w weights.txt)
answer("\n0 +1 +3\n" colors.ply -t 1 -e 0.1 -w property:red)
answer("\n0 +3 +2\n" colors.ply -t 3 -e 0.1 -w property:blue)

# three faces at an edge: it is cut, and its vertices are where any of their copies are
answer("\n2 +1 +1.4142135[0-9]+\n2 +0 +1\n" fan_of_three.off -s 2 -t 1 0)
answer("Written: " fan_of_three.off -s 0 -o fan --csv)
expect_contents(fan.csv "\n0,0,0,0,0,0\n1,1,0,0,1,0\n2,0,1,0,1,0\n3,0,-1,0,1,0\n4,0,0,1,1,0\n$")
answer("\n0 +2 +1\n0 +3 +1\n0 +4 +1\n" fan_of_three.off -s 0 -t 2 3 4)
file(WRITE ${folder}/edges.txt "0 1\n") # all copies of it
answer("\n2 +1 +1.4142135" fan_of_three.off -s 2 -t 1 -e 0.1 -b edges.txt)

# faces that look the other way, or are there twice
write_mesh(twisted.off "${square}" "3 0 1 2;3 0 3 2;3 2 1 0")
answer("\n3 +1 +1.4142135" twisted.off -s 3 -t 1 -e 0)
file(WRITE ${folder}/weights.txt "5\n3\n1000\n")
answer("\n0 +3 +3\n" twisted.off -t 3 -e 0.1 -w weights.txt)
answer("duplicates: 1, such as face 2; faces turned around, [^;]*: 1, such as face [01]\\. " twisted.off)
