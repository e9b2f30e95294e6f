/** UObjects as urbiscript sees them (manual, "UObject", "UVar"). */
package org.urbi.kernel.library.uobject;
