/**
 * What all programs' command lines have in common; the only place that knows picocli. Options are
 * declared by calls, and a plain command line is read without picocli: starting a script must not
 * take longer than running it.
 */
package org.urbi.server.options;
