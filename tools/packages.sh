# shellcheck shell=bash
# Debian 12 packages and what each is for, as lines "package: reason".

build_packages='
g++: C++20 compiler
cmake: configures the build
ninja-build: runs the build
pkg-config: finds netCDF and udunits
libeigen3-dev: linear algebra
libboost-dev: Boost.Math and Boost.Odeint
libtbb-dev: operating points in parallel
libnlopt-dev: best crown of rollers
libnlopt-cxx-dev: best crown of rollers, C++ header
libyaml-cpp-dev: case files
libudunits2-dev: units in case files
libcli11-dev: command line
libfmt-dev: formatting
nlohmann-json3-dev: JSON output
libnetcdf-dev: result files
libzip-dev: archives of FMUs
libcpp-httplib-dev: server of the page (orbearing open)
libpugixml-dev: model descriptions of FMUs
'

report_packages='
python3: reports
python3-numpy: reports
python3-matplotlib: figures of the reports
python3-netcdf4: reports, and tests that open result files as users do
python3-xarray: results as datasets
'

# Not needed for the demo.
more_packages='
weasyprint: reports as PDF
python3-scipy: typical conditions of an operating record; samples of studies
python3-openturns: samples and polynomial chaos of uncertain lives
'

windows_packages='
g++-mingw-w64-x86-64-posix: Windows library inside FMUs (orbearing fmu --windows)
'

test_packages='
libgtest-dev: C++ tests
libgmock-dev: matchers of the C++ tests
python3-yaml: tests of the command line
poppler-utils: tests that read the pages of a PDF
python3-jsonschema: test of the schema of case files
python3-xarray: tests that open result files as users do
python3-distributed: studies on the workers of a Dask cluster
python3-getfem: finite elements of others, of a rim that bends
python3-sphinx: documentation site (tools/site)
python3-myst-parser: the same, its reader of Markdown
codespell: spelling of sources and documents
python3-venv: FMI tools of others, installed below the build folder
chromium: the page of `orbearing open` in a browser
chromium-driver: the same, moved by a test
python3-selenium: the same, steps of the test
nodejs: scripts of the page without a browser, and what they draw
'

site_packages='
emscripten: the page with its core in the browser (WebAssembly)
dpkg-dev: unpacks the sources of yaml-cpp and NLopt for it
chromium: browser of its tests
chromium-driver: the same
python3-selenium: the same
'

bench_packages='
libbenchmark-dev: times of small kernels
libsundials-dev: CVODE, the general-purpose integrator to compare with
python3: runs of the program that are timed in turn
python3-numpy: a table of results that is timed
python3-venv: Exudyn, the multibody code to compare with, installed below the build folder
'

full_packages='
clang: second compiler and the fuzzer
libclang-rt-14-dev: run-time part of the fuzzer and of clang'"'"'s sanitizers
clang-tidy: static analysis
gcovr: line coverage
wine64: runs the Windows library of the FMUs
libsundials-dev: CVODE, whose runs the tests compare with ours
'

wheel_packages='
python3-venv: environments of the compiler (ziglang), and those in which the wheel is checked
dpkg-dev: unpacks the sources of the libraries inside
m4: builds one of them (netCDF)
binutils: versions of symbols
'

package_packages='
debhelper: builds Debian packages
dh-python: the same, of the Python package
dpkg-dev: the same
fakeroot: the same, without root
help2man: manual page
lintian: checks Debian packages
'
