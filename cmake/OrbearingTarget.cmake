# Targets whose include path holds exactly the folders they may depend on.
#
# Headers are included from the repository root ("bearing/life.hpp"). Putting the root itself on the
# include path would let every folder see every other, so each library gets a view of the tree that
# holds its own folder alone: build/view/<folder>/<folder> -> <folder>.

function(orbearing_view folder)
  set(view "${PROJECT_BINARY_DIR}/view/${folder}")
  file(MAKE_DIRECTORY "${view}")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${folder}" "${view}/${folder}" SYMBOLIC)
  set(ORBEARING_VIEW "${view}" PARENT_SCOPE)
endfunction()

function(orbearing_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wconversion -Wpedantic
    # Members that a designated initialiser leaves out keep the default that stands in the class.
    -Wno-missing-field-initializers
    # g++ 12 sees overlaps in std::string's own code (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    # A tenth of g++'s time goes into collecting garbage that a batch of sources makes: up to 2 GB it need not.
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000>
    # The same bits on every machine of an instruction set: no contraction of a*b+c behind our back.
    -ffp-contract=off
    $<$<BOOL:${ORBEARING_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# orbearing_unity_build(<target> [<times>]): compiles its sources together, in batches, since most of the time of a source goes
# into headers that its neighbours include as well. A folder is cut only where it is larger than a batch, so that a
# new file seldom moves those of other folders. CMake leaves out sources that have options of their own; what else
# shall stay alone has SKIP_UNITY_BUILD_INCLUSION. A number: batches so many times as large, where headers and what is
# made of them cost more than what is optimised.
function(orbearing_unity_build target)
  if(NOT ORBEARING_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(folders "")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    cmake_path(GET source PARENT_PATH folder)
    list(APPEND folders "${folder}")
    list(APPEND "files in ${folder}" "${source}")
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(most ${ORBEARING_UNITY_FILES})
  if(ARGC GREATER 1)
    math(EXPR most "${ARGV1} * ${most}")
  endif()
  set(batch 1)
  set(filled 0)
  foreach(folder IN LISTS folders)
    list(LENGTH "files in ${folder}" files)
    math(EXPR together "${filled} + ${files}")
    foreach(source IN LISTS "files in ${folder}")
      if(filled GREATER 0 AND (together GREATER most OR filled EQUAL most))
        math(EXPR batch "${batch} + 1")
        set(filled 0)
      endif()
      set(together 0)  # asked once a folder
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "batch_${batch}")
      math(EXPR filled "${filled} + 1")
    endforeach()
  endforeach()
endfunction()

# orbearing_common_headers(<target> [<headers>]): precompiles headers that nearly all batches of a target include, which
# saves a sixth of a build. Each source still has its own includes: the presets debug and tidy precompile nothing. Sources
# with options of their own do not share the headers, and ccache would not keep what does.
function(orbearing_common_headers target)
  if(NOT ORBEARING_UNITY_BUILD OR CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
    return()
  endif()
  # g++ 12 sees overflows in the standard library's own code, and says so of headers that are precompiled. The preset debug
  # keeps these warnings.
  target_compile_options(${target} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds;-Wno-maybe-uninitialized>)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <functional> <limits> <memory> <numeric> <optional>
    <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector> <Eigen/Core> <Eigen/LU> ${ARGN})
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(options "${source}" COMPILE_OPTIONS)
    get_source_file_property(definitions "${source}" COMPILE_DEFINITIONS)
    if(options OR definitions)
      set_source_files_properties("${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# orbearing_library(<folder> [NAME <name>] [OPTIMISATION <option>] [BATCHES <times>] SOURCES ... DEPENDS ...): the library
# orbearing_<folder>, alias orbearing::<folder>, or with the name instead where a folder has two. The option is that of
# releases. Options of single sources are set before it.
function(orbearing_library folder)
  cmake_parse_arguments(ARG "" "NAME;OPTIMISATION;BATCHES" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(name ${folder})
  if(ARG_NAME)
    set(name ${ARG_NAME})
  endif()
  set(target orbearing_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(orbearing::${name} ALIAS ${target})
  orbearing_view(${folder})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${ORBEARING_VIEW}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/orbearing>)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  orbearing_compile_options(${target})
  # The library inside FMUs takes what it uses from a batch of sources, no more.
  target_compile_options(${target} PRIVATE -ffunction-sections -fdata-sections $<$<CONFIG:Release>:${ARG_OPTIMISATION}>)
  orbearing_unity_build(${target} ${ARG_BATCHES})
  list(LENGTH ARG_SOURCES sources)
  if(sources GREATER ORBEARING_UNITY_FILES)
    orbearing_common_headers(${target})
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endfunction()
