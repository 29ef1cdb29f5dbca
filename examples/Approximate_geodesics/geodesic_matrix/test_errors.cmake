# What the user gets wrong is refused before anything is computed, with the name of the option and
# the reason.
include(${CMAKE_CURRENT_LIST_DIR}/../command_line/test_helpers.cmake)

expect(1 "no mesh given" ${PROGRAM})
expect(1 "unrecognised option .--eps" ${PROGRAM} ${mesh} --eps 0.1)
expect(1 "--output: x.csr must end with .npy" ${PROGRAM} ${mesh} --output x.csr)
expect(1 "--output: x.npy must end with .csr" ${PROGRAM} ${mesh} --output x.npy --nearest 3)
expect(1 "there is no folder missing" ${PROGRAM} ${mesh} --output missing/x.npy)
expect(1 "--nearest: \"-3\" is not a whole number from 1" ${PROGRAM} ${mesh} --nearest -3)
expect(1 "--epsilon: \"nan\" is not a number" ${PROGRAM} ${mesh} --epsilon nan)
expect(1 "--epsilon: it is -1, and must be" ${PROGRAM} ${mesh} --epsilon -1)
expect(1 "--epsilon: a value must follow, in place of --radius" ${PROGRAM} ${mesh} --epsilon --radius 1)
expect(1 "--output: .npy has only an ending" ${PROGRAM} ${mesh} --output .npy)
expect(1 "--sources 315: there is no vertex 315" ${PROGRAM} ${mesh} --sources 0 315)
expect(1 "--sources x: \"x\" is not the index of a vertex, nor all, random:K, farthest:K or file:NAME"
       ${PROGRAM} ${mesh} --sources x)
expect(1 "--targets random:1000: the mesh has 315 vertices" ${PROGRAM} ${mesh} --targets random:1000)
expect(1 "--symmetric: --targets must be" ${PROGRAM} ${mesh} --symmetric --targets random:3)
file(WRITE ${folder}/wrong.txt "0\n315\n")
expect(1 "--sources file:wrong.txt: line 2: there is no vertex 315" ${PROGRAM} ${mesh} --sources file:wrong.txt)
file(WRITE ${folder}/distances.npy "of somebody else")
expect(1 "distances.npy already exists" ${PROGRAM} ${mesh})
file(REMOVE ${folder}/distances.npy)
file(MAKE_DIRECTORY ${folder}/distances.npy.part)
expect(1 "--resume no: distances.npy.part belongs to an unfinished run" ${PROGRAM} ${mesh} --resume no)
expect_files(distances.npy.part wrong.txt)
expect(1 "^geodesic_matrix: cannot write to standard output: No space left on device\n$" sh -c
       "\"$0\" --help >/dev/full" ${PROGRAM})
