/** UObjects as urbiscript sees them (manual, "UObject", "UVar"). */
@NullMarked
package org.urbi.kernel.library.uobject;

import org.jspecify.annotations.NullMarked;
