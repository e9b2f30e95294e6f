/**
 * The tools that talk to a running server over a plain socket: {@code urbi-send} and {@code
 * urbi-ping} (manual, sections 21.7 and 21.8).
 */
@NullMarked
package org.urbi.server.tools;

import org.jspecify.annotations.NullMarked;
