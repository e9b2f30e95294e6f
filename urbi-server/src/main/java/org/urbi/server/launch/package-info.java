/** The program {@code urbi-launch-java}: UObjects in Java, plugged and remote. */
@NullMarked
package org.urbi.server.launch;

import org.jspecify.annotations.NullMarked;
