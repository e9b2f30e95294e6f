package org.urbi.kernel.library.system;

import java.util.List;

/**
 * How the server was called.
 *
 * @param programName the path under which it was called
 * @param arguments the arguments of the user's script
 */
public record CommandLine(String programName, List<String> arguments) {}
