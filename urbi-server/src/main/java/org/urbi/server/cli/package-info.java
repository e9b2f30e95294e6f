/**
 * The program {@code urbi}: a kernel with its inputs, its console and its network port, from the
 * start to the exit status (manual, section 21.3).
 */
@NullMarked
package org.urbi.server.cli;

import org.jspecify.annotations.NullMarked;
