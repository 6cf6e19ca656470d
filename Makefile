# The commands of the README, and what contributors run. Everything below them is CMake presets.
JOBS ?= $(shell nproc)
ARGS ?=
# With WERROR=ON warnings are errors, as in .ci/run. Without, a compiler that is newer than ours stops nobody.
WERROR ?= OFF
STRICT = -D CMAKE_COMPILE_WARNING_AS_ERROR=$(WERROR)

# What ninja says before each file: "[12 of 67 files, 41 s] ".
export NINJA_STATUS ?= [%f of %t files, %e s] $()

# The first answer needs nothing of the thesis (docs/decisions/0089). A build that has it keeps it.
FIRST = $(if $(wildcard build/release/CMakeCache.txt),,-D SOMS_BUILD_THESIS=OFF)
# All of soms, whatever `make run` left out.
ALL = -D SOMS_BUILD_THESIS=ON

.PHONY: help run build view thesis install python cluster configured test long headers large check wheel asan asan-library asan-python tsan tidy arm64 wasm-configured wasm live wasm-test determinism memcheck endurance packages bare fuzz faults bench format clean

help:
	@echo "make run     install what is missing, build, and run the embedded city (ARGS='--frames 60')"
	@echo "make build   the rest, too: the thesis, and what installed packages allow"
	@echo "make view    install what is missing, build, and open the viewer on the embedded city"
	@echo "make thesis  the thesis' experiments on the models of MODELS=DIR, compared with the golden tables;"
	@echo "             page, tables and PDF go to OUT=soms-thesis (ARGS=--quick: a few minutes)"
	@echo "make install  install what is missing, build all of soms, and put it into PREFIX=/usr/local"
	@echo "make python  install what is missing, and leave the wheel of the Python package in build/python"
	@echo "make cluster install Dask, build the Python package, and share poses out over the processors (ARGS=100000)"
	@echo "make test    install what is missing, build, and run the tests of the release build but those that take long"
	@echo "make long    make test, then those"
	@echo "             (WERROR=ON, here and below: warnings of the compiler are errors)"
	@echo "make check   make test, then the suite under ASan+UBSan, the library under TSan, clang-tidy, ARM, WebAssembly,"
	@echo "             packages, and the README's commands on a bare Debian"
	@echo "make fuzz    every fuzzer for a minute (FUZZ_SECONDS=600)"
	@echo "make faults  faults put into a copy of the source, one at a time: which test finds each? (ARGS='--only NAME')"
	@echo "make wasm    the npm package soms for node and browsers, in build/web, ready for npm pack"
	@echo "make live    the WebAssembly module that report pages carry, in apps/report/web/dist"
	@echo "make wasm-test  the package and its golden answers, tested in node and in a headless Chromium"
	@echo "make bench   soms beside its peers, in one run (ARGS=--quick: a few minutes)"
	@echo "make format  clang-format on every source"
	@echo "make clean   remove build/"

run:
	@echo "1 of 3: packages that are missing"
	@tools/install_packages.sh run
	@echo "2 of 3: build the command on $(JOBS) cores, once; some minutes, up to 1 GB of memory for each core"
	cmake --preset release -D SOMS_BUILD_TESTS=OFF $(FIRST)
	cmake --build --preset release -j $(JOBS) --target soms_command
	@echo "3 of 3: run it"
	build/release/bin/soms simulate $(ARGS)

# All that an installed soms has. What misses a package is left out, aloud.
build:
	@tools/install_packages.sh run
	cmake --preset release -D SOMS_BUILD_TESTS=OFF $(ALL)
	cmake --build --preset release -j $(JOBS) --target soms_installed

view:
	@tools/install_packages.sh run view
	cmake --preset release -D SOMS_BUILD_TESTS=OFF $(FIRST)
	cmake --build --preset release -j $(JOBS) --target soms_command soms_view_command
	build/release/bin/soms view $(ARGS)

# The experiments of the thesis, checked and printed. Without MODELS generated stand-ins are used; PDF= leaves the PDF
# out, and Chromium with it.
MODELS ?=
OUT ?= soms-thesis
PDF ?= $(OUT)/thesis.pdf
thesis:
	@tools/install_packages.sh run $(if $(PDF),thesis)
	cmake --preset release -D SOMS_BUILD_TESTS=OFF $(ALL)
	cmake --build --preset release -j $(JOBS) --target soms_command soms_reproduce_command
	build/release/bin/soms reproduce $(if $(MODELS),--models "$(MODELS)") --golden tests/data/thesis --latex -o "$(OUT)" \
	  $(if $(PDF),--pdf "$(PDF)") $(ARGS)

# Whatever `make run` or `make test` left in the build, the rest of what is installed is built first. DESTDIR= goes
# before the prefix, as packagers want it.
PREFIX ?= /usr/local
install:
	@tools/install_packages.sh run view import
	cmake --preset release -D SOMS_BUILD_TESTS=OFF $(ALL)
	cmake --build --preset release -j $(JOBS) --target soms_installed
	cmake --install build/release --prefix "$(PREFIX)"

# The wheel of the Python package, self-contained.
python:
	@tools/install_packages.sh python
	@tools/build_wheel.sh "$(CURDIR)/build/python"

# Where a car stands free in a city, by Dask.
cluster:
	@tools/install_packages.sh run python cluster
	cmake --preset release -D SOMS_BUILD_TESTS=OFF -D SOMS_BUILD_PYTHON=ON
	cmake --build --preset release -j $(JOBS) --target soms_python_package
	PYTHONPATH=build/release/python /usr/bin/python3 python/examples/many_poses.py $(ARGS)

# The release build with its tests. Parts of `make check` build only what they need of it.
configured:
	@tools/install_packages.sh run view import test
	cmake --preset release -D SOMS_BUILD_TESTS=ON $(ALL) -D SOMS_BUILD_PYTHON=ON $(STRICT)

test: configured
	cmake --build --preset release -j $(JOBS)
	@tools/install_web_ifc.sh build/release
	@echo "Not part of this: tests that take long (make long), and the npm package (make wasm-test)"
	ctest --preset release -j $(JOBS) -E '$(LONG)'

# The tests that tests/long.txt names, after `make test`.
LONG = $(shell grep -v '^\#' tests/long.txt | paste -sd '|')
long: test
	ctest --preset release -j $(JOBS) -R '$(LONG)'

# The suite once more, every access and every arithmetic step watched.
asan:
	@tools/install_packages.sh run view import test
	cmake --preset $@ $(STRICT)
	cmake --build --preset $@ -j $(JOBS)
	ctest --preset $@ -j $(JOBS)

# The tests of the library only, by their labels: under clang's ASan+UBSan with the fuzzers' inputs, and under TSan,
# with std::jthread in place of TBB.
LIBRARY = base geometry kinematics tree query motion thesis scene clash robot io store tiles generate properties regressions
asan-library: TESTED = $(or $(ROOMS),$(LIBRARY) fuzz)
tsan: TESTED = $(LIBRARY)
asan-library tsan:
	@tools/install_packages.sh run import test $(if $(filter asan-library,$@),sanitize)
	cmake --preset $@ -D SOMS_BUILD_VIEW=OFF $(STRICT)
	cmake --build --preset $@ -j $(JOBS) --target $(TESTED:%=%_test)
	ctest --preset $@ -j $(JOBS) -L '^($(shell echo $(TESTED) | tr ' ' '|'))$$'

# The Python package, the library in it included, under ASan+UBSan and LeakSanitizer. The interpreter is not built
# with them, so their libraries are loaded first. Leaks are named by two frames, so that tests/python/leaks.txt can
# tell what CPython allocates itself; PYTHONMALLOC=malloc lets the search see through its objects.
SANITIZERS = $(shell $(CXX) -print-file-name=libasan.so):$(shell $(CXX) -print-file-name=libubsan.so):$(shell $(CXX) -print-file-name=libstdc++.so.6)
asan-python:
	@tools/install_packages.sh run test
	cmake --preset asan -D SOMS_BUILD_PYTHON=ON $(STRICT)
	cmake --build --preset asan -j $(JOBS) --target soms_python_package
	for test in answers clash errors index interrupts misuse notebook page pickles recording robot scene truth values; do \
	  LD_PRELOAD=$(SANITIZERS) ASAN_OPTIONS=malloc_context_size=2:allocator_may_return_null=1 PYTHONMALLOC=malloc \
	    LSAN_OPTIONS=suppressions=tests/python/leaks.txt:print_suppressions=0 \
	    UBSAN_OPTIONS=print_stacktrace=1 PYTHONPATH=build/asan/python \
	    /usr/bin/python3 tests/python/$${test}_test.py || exit 1; done

# Every public header, compiled alone.
headers: configured
	cmake --build --preset release -j $(JOBS) --target all_verify_interface_header_sets

# Everything, tests included: hours. SINCE=COMMIT looks only at sources of library, programs and thesis that changed since.
SINCE ?=
tidy:
	@tools/install_packages.sh run test check
	cmake --preset tidy $(STRICT)
	$(if $(SINCE),tools/tidy.py -j $(JOBS) $(SINCE),cmake --build --preset tidy -j $(JOBS))

# Queries with NEON kernels, cross-compiled and run by qemu.
arm64:
	@tools/install_packages.sh arm64
	cmake -G Ninja -S tests/arm64 -B build/arm64 -D CMAKE_BUILD_TYPE=Release \
	  -D CMAKE_TOOLCHAIN_FILE=$(CURDIR)/cmake/arm64.cmake
	cmake --build build/arm64 -j $(JOBS)
	ctest --test-dir build/arm64 --output-on-failure

# The npm package: WebAssembly by Debian's emscripten. Minutes to build, so its tests are part of `make check`.
wasm-configured:
	@tools/install_packages.sh web
	cmake -G Ninja -S web -B build/wasm -D SOMS_WEB_PACKAGE=$(CURDIR)/build/web -D SOMS_WEB_DEMO=$(CURDIR)/build/web-demo \
	  -D CMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake

wasm: wasm-configured
	cmake --build build/wasm -j $(JOBS) --target demo
	@echo "The npm package is in build/web: npm install $(CURDIR)/build/web, or npm pack there."
	@echo "A page that shows it: python3 -m http.server --directory build/web-demo"

# The module that reports carry (docs/decisions/0059): committed, and made again where test report.live_hash says so.
live: wasm-configured
	cmake --build build/wasm -j $(JOBS) --target soms_live
	web/pack_live.py build/wasm apps/report/web/dist

wasm-test: wasm
	cmake --build build/wasm -j $(JOBS)
	ctest --test-dir build/wasm --output-on-failure

# The golden answers, by each compiler with each optimization.
determinism:
	@tools/install_packages.sh run check
	tests/determinism/run.sh build/determinism $(JOBS)

# A hundred thousand frames, kills at random moments, disks that are full or read-only.
endurance: configured
	cmake --build --preset release -j $(JOBS) --target soms_command soms_reproduce_command
	python3 tests/endurance/endurance.py build/release/bin/soms

# Every byte that the golden answers read must have been written.
memcheck: configured
	cmake --build --preset release -j $(JOBS) --target golden
	@command -v valgrind >/dev/null || { echo "skipped: memcheck, as valgrind is not installed"; exit 0; } && \
	  valgrind -q --tool=memcheck --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite \
	    build/release/tests/golden/golden tests/data write > build/memcheck.csv && \
	  diff tests/golden/answers.csv build/memcheck.csv && echo "memcheck: no errors"

# The installed library as outside programs see it, static and shared, the Debian packages, and the
# command on a processor without any vector extension. The packages stay in build/package.
packages: configured
	@tools/install_packages.sh packages
	cmake --build --preset release -j $(JOBS) --target soms_installed
	cmake --preset package -D SOMS_BUILD_PYTHON=ON $(STRICT)
	cmake --build --preset package -j $(JOBS)
	ctest --preset release -R R99Answers
	python3 tests/install/packages_test.py . build/release build/package c++ clang++
	python3 tests/install/deb_test.py . build/package build/bare

# Both commands of the README on a Debian that has nothing but git and make; the wheel, if there is one, on a Debian
# that has nothing but python3 and numpy.
bare:
	@tools/install_packages.sh bare
	python3 tests/install/bare_debian_test.py . build/bare || [ $$? -eq 77 ]
	python3 tests/install/wheel_bare_test.py build/python build/bare || [ $$? -eq 77 ]

# Each fuzzer for FUZZ_SECONDS, on its seeds and the inputs that it found before; build/fuzz/corpus
# keeps them, build/fuzz/results.csv counts. tests/fuzz/README.md tells more.
FUZZ_SECONDS ?= 60
fuzz:
	@tools/install_packages.sh run test check
	cmake --preset fuzz $(STRICT)
	cmake --build --preset fuzz -j $(JOBS)
	@tools/run_fuzzers.py --seconds $(FUZZ_SECONDS)

# Each fault of tools/faults/*.toml is put into a copy of the source, built and looked for: an hour or more. The copy
# stays in build/faults; `tools/faults.py --help` says how faults are added.
faults:
	@tools/install_packages.sh run view test
	@tools/faults.py -j $(JOBS) $(ARGS)

# What takes too long for every run of the suite: builds of 5 million triangles, a million calls of
# Python.
large: test
	SOMS_TEST_LARGE=1 ctest --preset release -R 'FiveMillion|R98'

# The wheel in an environment of its own.
wheel: configured python
	ctest --preset release -R R99TheWheel

check: WERROR = ON
check: test long headers large wheel asan asan-python tsan tidy arm64 wasm-test determinism memcheck endurance packages bare

# Peers that cannot be installed are left out. A quick run: ARGS=--quick; soms-bench --help tells more.
bench:
	@tools/install_packages.sh run bench
	-@tools/install_packages.sh peers
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)
	build/bench/bin/soms-bench $(ARGS)

format:
	@git ls-files '*.h' '*.cpp' | xargs clang-format -i

clean:
	rm -rf build
