/**
 * The functions of all objects, and groups of objects (manual, "Object", "Global", "Finalizable",
 * "Group", "Pattern").
 */
@NullMarked
package org.urbi.kernel.library.object;

import org.jspecify.annotations.NullMarked;
