/** Tags, and code under tags. */
package org.urbi.kernel.tag;
