/**
 * Functions of every value (comparing, hashing, printing), and the plain types (manual, "Boolean",
 * "nil", "void", "Enumeration", "Comparable", "Orderable").
 */
@NullMarked
package org.urbi.kernel.library.value;

import org.jspecify.annotations.NullMarked;
