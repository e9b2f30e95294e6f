/**
 * The kernel as a library: evaluation, calls and subscriptions from any thread of a Java program.
 */
package org.urbi.kernel.embed;
