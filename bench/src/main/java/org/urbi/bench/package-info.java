/** Whole programs run side by side in urbiscript, Python and Lua, and the time to start up. */
@NullMarked
package org.urbi.bench;

import org.jspecify.annotations.NullMarked;
