/**
 * The programs around the kernel: the network console, the command line and its tools.
 *
 * <p>{@code net} lets telnet clients in, {@code console} is the terminal or the standard input and
 * output, {@code studio} is for browsers, {@code cli} is the program {@code urbi} that puts them
 * together, {@code tools} are {@code urbi-send} and {@code urbi-ping}, which only know a socket.
 * This package itself holds what they share; docs/architecture.md has all of them.
 */
@NullMarked
package org.urbi.server;

import org.jspecify.annotations.NullMarked;
