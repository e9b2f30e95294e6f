/** How the library's Java methods are called. */
package org.urbi.kernel.builtin;
