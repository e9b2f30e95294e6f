/** Whole programs run side by side in urbiscript, Python and Lua, and the time to start up. */
package org.urbi.bench;
