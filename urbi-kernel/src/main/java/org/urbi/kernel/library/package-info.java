/**
 * The standard library: one class for each type of the manual, whose static methods are the slots
 * of its prototype. Classes that are not named after a type help several of them.
 */
package org.urbi.kernel.library;
