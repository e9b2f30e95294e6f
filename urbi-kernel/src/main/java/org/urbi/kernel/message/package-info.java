/**
 * What comes into a kernel from the outside: data alone, which can be written down and read again.
 */
package org.urbi.kernel.message;
