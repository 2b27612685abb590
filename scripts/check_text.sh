#!/usr/bin/env bash
# What can be said of the files without compiling them: format of the code, faults of the scripts,
# spelling (words that are right here and rare elsewhere: .codespellrc), types of the Python package,
# one version in all files, pages that agree with the sources, answers within two clicks of README.md, words
# that no native engineer would write.
set -euo pipefail
cd "$(dirname "$0")/.."

failures=0
git ls-files '*.cpp' '*.hpp' '*.h' '*.c' | xargs clang-format --dry-run --Werror || failures=1
git ls-files '*.sh' .ci/run | xargs shellcheck || failures=1
git ls-files -- ':!profiles/*.toml' ':!tests/fuzz/corpus' ':!docs/images' ':!*.ipynb' | xargs codespell || failures=1
mypy --cache-dir build/mypy --config-file python_bindings/pyproject.toml \
  python_bindings/wrcontact python_bindings/examples/*.py drivers/evidence/varying/*.py drivers/evidence/half_space_limits/*.py \
  drivers/evidence/finite_elements/*.py || failures=1
version=$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
grep -qx "version: $version" CITATION.cff || {
  echo "CITATION.cff: version must be that of CMakeLists.txt, $version"
  failures=1
}
grep -qx "version = \"$version\"" fpm.toml || {
  echo "fpm.toml: version must be that of CMakeLists.txt, $version"
  failures=1
}
grep -q "^Version $version, " README.md || {
  echo "README.md: version must be that of CMakeLists.txt, $version"
  failures=1
}
scripts/check_docs.py || failures=1
scripts/check_questions.py || failures=1
scripts/check_words.py || failures=1
exit "$failures"
