/** What it costs to cross the boundary between urbiscript and C++. */
@NullMarked
package org.urbi.bench.crossing;

import org.jspecify.annotations.NullMarked;
