# What does not fulfill a concept is told so in the first line of the compiler's errors.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  return()
endif()

function(compile_models name)
  add_test(
    NAME ${name}
    COMMAND
      ${CMAKE_CXX_COMPILER} -std=c++17 -fsyntax-only -Wfatal-errors ${ARGN}
      "-I$<JOIN:$<TARGET_PROPERTY:test_settings,INTERFACE_INCLUDE_DIRECTORIES>,;-I>"
      ${CMAKE_CURRENT_SOURCE_DIR}/Search/wrong_models.cpp
    COMMAND_EXPAND_LISTS)
endfunction()

function(refuse_wrong_model what message)
  compile_models(refuse_wrong_${what} -DWRONG_${what})
  set_tests_properties(refuse_wrong_${what} PROPERTIES PASS_REGULAR_EXPRESSION
                                                       "error: static.assert[^\n]*${message}")
endfunction()

compile_models(accept_right_models)
set(graph "A model of GeodesicGraph must have")
set(queue "A model of GeodesicPriorityQueue must have")
refuse_wrong_model(NODE "${graph} a type .Node., which is .std::uint32_t.")
refuse_wrong_model(NUMBER_OF_NODES "${graph} .std::size_t number_of_nodes.. const.")
refuse_wrong_model(FOR_EACH_ARC "${graph} .for_each_arc.Node node, const Labels& labels, F f. const.")
refuse_wrong_model(ENTRY "An .Entry. of a model of GeodesicPriorityQueue .*: first the key")
refuse_wrong_model(CONSTRUCTOR "${queue} a constructor")
refuse_wrong_model(PUSH "${queue} .void push.Node node, Key key.")
refuse_wrong_model(FOR_EACH_NODE "${queue} .for_each_node.F f. const.")
refuse_wrong_model(UNIT "${graph} .double unit.. const.")
refuse_wrong_model(ARC_LENGTHS "${graph} .Arc_lengths arc_lengths.. const.")
refuse_wrong_model(EXTRACT_MIN "${queue} .Batch extract_min...")
refuse_wrong_model(BATCH "The .Batch. of a model of GeodesicPriorityQueue must have")
refuse_wrong_model(IS_EMPTY "${queue} .bool is_empty.. const.")
refuse_wrong_model(IS_FINAL "${queue} .bool is_final.Key key. const.")
refuse_wrong_model(CLEAR "${queue} .void clear...")
refuse_wrong_model(MEMORY "${queue} .std::size_t memory.. const.")
