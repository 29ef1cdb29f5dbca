# The program writes the same file by one thread and by two, tells before what it will be, and leaves
# nothing else.
include(${CMAKE_CURRENT_LIST_DIR}/../command_line/test_helpers.cmake)

expect(0 "length of the file +397 kB" ${PROGRAM} ${mesh} --epsilon 0.1 --estimate)
expect_files()
expect(0 "length of the file +397 kB" ${PROGRAM} ${mesh} --epsilon 0.1 --output one.npy --threads 1)
expect(0 "rows +315" ${PROGRAM} ${mesh} --epsilon 0.1 --output all.npy)
expect_same(one.npy all.npy)

file(WRITE ${folder}/vertices.txt "# some vertices\n314\n0 # the first one\n\n7\n")
expect(0 "rows +3\n.*columns +20\n" ${PROGRAM} ${mesh} --sources file:vertices.txt --targets farthest:20
       --type float64 --output some.npy)
expect(0 "rows +6\n.*columns +2\n" ${PROGRAM} ${mesh} --sources 7 file:vertices.txt random:2 --targets 0 5
       --output mixed.npy)
expect(0 "rows +30\n.*columns +30\n" ${PROGRAM} ${mesh} --sources random:30 --epsilon 0 --symmetric
       --output symmetric.npy)
expect(0 "microseconds a row" ${PROGRAM} ${mesh} --radius 0.5 --nearest 9 --output near.csr/)
expect_files(all.npy mixed.npy near.csr one.npy some.npy symmetric.npy vertices.txt)
