/**
 * UObjects that are written in C++: loads shared libraries that were compiled with {@code
 * urbi/uobject.hh}, and shows their classes as UObjects in any {@link urbi.UContext}.
 *
 * <p>Everything crosses the boundary in an {@link org.urbi.bridge.Exchange}; {@link
 * org.urbi.bridge.ModuleFunctions} is all that is known of a library, and {@link
 * org.urbi.bridge.RequestHandler} all that a library may ask for. How the two are called is a
 * matter of {@link org.urbi.bridge.JnaLibrary} alone.
 */
@NullMarked
package org.urbi.bridge;

import org.jspecify.annotations.NullMarked;
