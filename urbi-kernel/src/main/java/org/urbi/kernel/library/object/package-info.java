/**
 * What all objects can do, and groups of them (manual, "Object", "Global", "Finalizable", "Group",
 * "Pattern").
 */
@NullMarked
package org.urbi.kernel.library.object;

import org.jspecify.annotations.NullMarked;
