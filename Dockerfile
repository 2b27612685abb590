# The bare Debian 12 machine of README.md: docker build . installs, builds and runs the tests.
FROM debian:12
WORKDIR /wrcontact
COPY . .
RUN scripts/test.sh
