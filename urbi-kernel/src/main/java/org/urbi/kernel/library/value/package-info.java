/**
 * What every value can be asked: comparing, hashing, printing, and the plain types (manual,
 * "Boolean", "nil", "void", "Enumeration", "Comparable", "Orderable").
 */
package org.urbi.kernel.library.value;
