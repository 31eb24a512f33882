# What stiction::validation links.
find_dependency(GSL 2.7)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_dependency(CGAL 5.5)
find_dependency(fmt 9)
find_dependency(nlohmann_json 3.11)
find_dependency(tomlplusplus 3.3)
find_dependency(TBB)
