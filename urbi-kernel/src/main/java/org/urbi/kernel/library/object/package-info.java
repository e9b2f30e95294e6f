/**
 * What all objects can do, and groups of them (manual, "Object", "Global", "Finalizable", "Group",
 * "Pattern").
 */
package org.urbi.kernel.library.object;
