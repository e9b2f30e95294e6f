/** The errors of the language and their texts. */
package org.urbi.kernel.error;
