/**
 * The program {@code umake-java}: from sources to a module, a jar of UObjects (manual, "The
 * umake-java and urbi-launch-java tools").
 */
@NullMarked
package org.urbi.server.make;

import org.jspecify.annotations.NullMarked;
