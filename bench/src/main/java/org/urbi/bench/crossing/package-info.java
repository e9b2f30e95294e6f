/** What it costs to cross the boundary between urbiscript and C++. */
package org.urbi.bench.crossing;
