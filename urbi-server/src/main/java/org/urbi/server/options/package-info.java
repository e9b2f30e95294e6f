/**
 * What all programs' command lines have in common; the only place that knows picocli. Options are
 * declared by calls, and a plain command line is read without picocli: starting a script must not
 * take longer than running it.
 */
@NullMarked
package org.urbi.server.options;

import org.jspecify.annotations.NullMarked;
