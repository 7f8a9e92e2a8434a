# What `cmake --install` installs, and the packages that CPack makes from it.

install(TARGETS afterglow RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS pictures LIBRARY DESTINATION ${module_dir})
install(DIRECTORY shaders presets docs DESTINATION ${CMAKE_INSTALL_DATADIR}/afterglow)

set(package_files ${PROJECT_SOURCE_DIR}/app/package)
install(FILES ${package_files}/afterglow.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${package_files}/afterglow.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${package_files}/afterglow.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${package_files}/afterglow.thumbnailer
    DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)
# Man pages, completions and metadata, which write_pages makes for ./run package.
install(DIRECTORY ${PROJECT_BINARY_DIR}/pages/share/ DESTINATION ${CMAKE_INSTALL_DATADIR} OPTIONAL)

set(CPACK_PACKAGE_NAME afterglow)
set(CPACK_PACKAGE_CONTACT "Afterglow contributors <afterglow@afterglow.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "lab for CRT, phosphor and oscilloscope looks")
set(CPACK_PACKAGE_DESCRIPTION
"Afterglow draws the light of cathode ray tubes: the beam of an oscilloscope,
the decay of phosphor, the mask of a colour tube. Open a look, run it on a live
signal or a picture, and tune every value with a slider. Inspect every
intermediate picture, and edit the shaders in your own editor.
.
Shaders of RetroArch, ISF and Shadertoy also open. All commands work without a
display.")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded while running, so that they are not found in the program.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri, fonts-dejavu-core, fonts-inter")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "chromium")
include(CPack)
